import { FILE_VERSION } from './FarolFile';
import type { JsonRecord } from './ProblemList';

/**
 * Migrations of a file from the version that is the key to the next one. Each gets a copy of the file, and checks only
 * what it changes.
 */
export const fileMigrations: Readonly<Record<number, (file: JsonRecord) => JsonRecord>> = {
  // version 2 adds prefabs and embedded assets; the rest is unchanged
  1: (file) => file,
  // version 3 adds scripts, clips and sounds; the rest is unchanged
  2: (file) => file,
};

/** A file of an older version, as one of this version. Its parts are checked afterwards. */
export function migrateFile(file: JsonRecord): JsonRecord {
  let migrated: JsonRecord = { ...file };
  for (let version = file.version as number; version < FILE_VERSION; version++) {
    migrated = { ...fileMigrations[version](migrated), version: version + 1 };
  }
  return migrated;
}
