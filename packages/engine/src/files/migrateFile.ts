import { FILE_VERSION } from './FarolFile';
import type { JsonRecord } from './ProblemList';

/**
 * Migrations by the version that each converts from, to the next version. Each gets a copy of the file, and checks only
 * the parts that it changes.
 */
export const fileMigrations: Readonly<Record<number, (file: JsonRecord) => JsonRecord>> = {
  // version 2 adds prefabs and embedded assets; the rest is unchanged
  1: (file) => file,
  // version 3 adds scripts, clips and sounds; the rest is unchanged
  2: (file) => file,
};

/** Converts a file of an older version to the current one. Its parts are checked afterwards. */
export function migrateFile(file: JsonRecord): JsonRecord {
  let migrated: JsonRecord = { ...file };
  for (let version = file.version as number; version < FILE_VERSION; version++) {
    migrated = { ...fileMigrations[version](migrated), version: version + 1 };
  }
  return migrated;
}
