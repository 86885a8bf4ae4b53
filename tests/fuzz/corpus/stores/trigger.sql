CREATE TRIGGER more AFTER INSERT ON assessments BEGIN INSERT INTO assessments SELECT NULL, test_id, name || 'x', verdict, value, tick, actor, robustness FROM assessments; END;
