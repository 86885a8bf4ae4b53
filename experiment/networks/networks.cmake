# Small neural networks. Included by CMakeLists.txt above.
target_sources(jaywalk_experiment PRIVATE
  networks/layer.cpp
  networks/network.cpp)
