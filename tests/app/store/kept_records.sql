PRAGMA foreign_keys=OFF;
BEGIN TRANSACTION;
CREATE TABLE recipe (
                    id INTEGER PRIMARY KEY,
                    name TEXT NOT NULL UNIQUE COLLATE NOCASE,
                    deleted INTEGER NOT NULL DEFAULT 0, name_key TEXT);
CREATE TABLE recipe_version (
                    recipe INTEGER NOT NULL REFERENCES recipe (id),
                    version INTEGER NOT NULL,
                    saved_ms INTEGER NOT NULL,
                    saved_by TEXT NOT NULL,
                    kind TEXT NOT NULL,
                    json BLOB NOT NULL, clock_doubtful INTEGER NOT NULL DEFAULT 0,
                    PRIMARY KEY (recipe, version)) WITHOUT ROWID;
CREATE TABLE machine_data (
                    kind TEXT PRIMARY KEY,
                    saved_ms INTEGER NOT NULL,
                    saved_by TEXT NOT NULL,
                    json BLOB NOT NULL) WITHOUT ROWID;
CREATE TABLE alarm (
                    id INTEGER PRIMARY KEY,
                    code TEXT NOT NULL,
                    raised_ms INTEGER NOT NULL,
                    ending INTEGER NOT NULL,
                    returned_ms INTEGER,
                    wants_acknowledgement INTEGER NOT NULL,
                    acknowledged_ms INTEGER,
                    acknowledged_by TEXT NOT NULL,
                    count INTEGER NOT NULL,
                    shelved INTEGER NOT NULL,
                    detail TEXT NOT NULL, clock_doubtful INTEGER NOT NULL DEFAULT 0);
INSERT INTO alarm VALUES(1,'C-01',1790000000000,1,1790000001500,1,1790000000900,'Anna, B',3,1,'=axis "1"',0);
INSERT INTO alarm VALUES(2,'W-05',1790000002000,0,NULL,0,NULL,'',1,0,'',1);
INSERT INTO alarm VALUES(3,'P-10',1790000003000,2,NULL,1,NULL,'',2,0,'色标',0);
CREATE TABLE alarm_shelf (
                    code TEXT PRIMARY KEY,
                    since_ms INTEGER NOT NULL,
                    until_ms INTEGER NOT NULL,
                    shelved_by TEXT NOT NULL) WITHOUT ROWID;
INSERT INTO alarm_shelf VALUES('C-01',1790000000000,1790003600000,'Anna, B');
CREATE TABLE user (
                    id INTEGER PRIMARY KEY,
                    name TEXT NOT NULL COLLATE NOCASE,
                    level INTEGER NOT NULL,
                    pin TEXT NOT NULL,
                    failed INTEGER NOT NULL DEFAULT 0,
                    locked_until_ms INTEGER NOT NULL DEFAULT 0,
                    deleted INTEGER NOT NULL DEFAULT 0, name_key TEXT);
CREATE TABLE audit (
                    sequence INTEGER PRIMARY KEY,
                    time_ms INTEGER NOT NULL,
                    who TEXT NOT NULL,
                    level INTEGER NOT NULL,
                    what TEXT NOT NULL,
                    object TEXT NOT NULL,
                    before TEXT NOT NULL,
                    after TEXT NOT NULL,
                    read_back TEXT NOT NULL,
                    outcome TEXT NOT NULL,
                    previous BLOB NOT NULL,
                    hash BLOB NOT NULL, clock_doubtful INTEGER NOT NULL DEFAULT 0);
INSERT INTO audit VALUES(1,1790000000000,'Anna, B',2,'parameter.write','parameter.gain','-1.5','2e-3','0.002','done',X'0000000000000000000000000000000000000000000000000000000000000000',X'6627e8b5c39c1e5a8463fd7fa879c005794b50899097f1ab9379d20fc8046e9c',0);
INSERT INTO audit VALUES(2,1790000000001,'',0,'user.login','Bo','','@x','','refused 7',X'6627e8b5c39c1e5a8463fd7fa879c005794b50899097f1ab9379d20fc8046e9c',X'd2b77df550c2856ebf3ce9bc445c86df009355e54f2a9ee3f9e2988f61f7e4a4',1);
CREATE TABLE audit_start (sequence INTEGER NOT NULL, hash BLOB NOT NULL);
CREATE TABLE state_interval (
                    id INTEGER PRIMARY KEY,
                    stop INTEGER NOT NULL,
                    state INTEGER NOT NULL,
                    begin_ms INTEGER NOT NULL,
                    duration_ms INTEGER NOT NULL,
                    program TEXT NOT NULL,
                    version INTEGER NOT NULL,
                    ideal_per_min REAL NOT NULL,
                    cycles INTEGER NOT NULL,
                    pieces INTEGER NOT NULL,
                    out_of_tolerance INTEGER NOT NULL,
                    start_up_scrap INTEGER NOT NULL,
                    skipped INTEGER NOT NULL, clock_doubtful INTEGER NOT NULL DEFAULT 0);
INSERT INTO state_interval VALUES(1,0,2,1790000000000,60000,'Biscuit 250',3,120.5,70,55,2,1,4,0);
INSERT INTO state_interval VALUES(2,2,1,1790000060000,30500,'Biscuit 250',3,0.0,70,0,0,0,0,1);
INSERT INTO state_interval VALUES(3,2,7,1790000090500,1000,'',0,99.900000000000005687,70,0,0,0,0,0);
CREATE TABLE stop (
                    id INTEGER PRIMARY KEY,
                    reason TEXT NOT NULL,
                    planned INTEGER NOT NULL,
                    answered_by TEXT NOT NULL,
                    answered_ms INTEGER NOT NULL);
INSERT INTO stop VALUES(2,'Foil, torn',1,'Anna, B',1790000070000);
CREATE TABLE clock_proof (time_ms INTEGER NOT NULL, audit_sequence INTEGER NOT NULL);
CREATE INDEX alarm_active ON alarm (ending) WHERE ending = 0;
CREATE INDEX alarm_unacknowledged ON alarm (code, id)
                    WHERE acknowledged_ms IS NULL AND wants_acknowledgement = 1;
CREATE UNIQUE INDEX user_name ON user (name) WHERE deleted = 0;
CREATE INDEX state_interval_begin ON state_interval (begin_ms);
CREATE INDEX state_interval_stop ON state_interval (stop);
CREATE INDEX alarm_raised ON alarm (raised_ms);
CREATE INDEX audit_time ON audit (time_ms);
CREATE UNIQUE INDEX recipe_name_key ON recipe (name_key);
CREATE UNIQUE INDEX user_name_key ON user (name_key) WHERE deleted = 0;
COMMIT;
PRAGMA user_version=9;
