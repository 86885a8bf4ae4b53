# Small neural networks. Included by CMakeLists.txt above.
target_sources(jaywalk_experiment PRIVATE
  networks/network.cpp
  networks/product.cpp)
# Each product and each sum must be rounded by itself, on every machine.
set_source_files_properties(networks/product.cpp PROPERTIES COMPILE_OPTIONS -ffp-contract=off)
