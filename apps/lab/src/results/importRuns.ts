import type { LabRun } from './LabRun';
import { messageOf } from '../run/messageOf';
import { LONGEST_RUN, parseRun } from './parseRun';
import type { RunStore } from './RunStore';

export interface Imported {
  readonly runs: readonly LabRun[];
  /** Reasons why files were refused, each a sentence with the file's name. */
  readonly problems: readonly string[];
}

/** Reads runs from files, and keeps new ones. A run that cannot be kept is returned nevertheless. */
export async function importRuns(files: Iterable<File>, store: RunStore): Promise<Imported> {
  const runs: LabRun[] = [];
  const problems: string[] = [];
  for (const file of files) {
    try {
      if (file.size > 4 * LONGEST_RUN) throw new Error(`it has ${Math.round(file.size / 1e6)} MB, too big for a run.`);
      const run = parseRun(await file.text());
      runs.push(run);
      if (!(await store.has(run.id))) await store.save(run);
    } catch (error) {
      problems.push(`${file.name}: ${messageOf(error)}`);
    }
  }
  return { runs, problems };
}
