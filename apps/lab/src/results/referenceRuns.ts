import type { LabRun } from './LabRun';
import { parseRun } from './parseRun';
import type { RunInfo } from './RunStore';

export interface ReferenceRun {
  readonly info: RunInfo;
  /** Fetches the run; a second call returns the same one. @throws Error (as a rejection) with the remedy */
  read(): Promise<LabRun>;
}

/** Addresses of the files `apps/lab/reference/*.json`, which are not part of the script. */
const urls = import.meta.glob<string>('../../reference/*.json', { query: '?url', import: 'default', eager: true });

/** Each reference as an entry of the list of runs, part of the script: the run is fetched only when opened. */
const infos = import.meta.glob<RunInfo>('../../reference/*.json', {
  query: '?run-info',
  import: 'default',
  eager: true,
});

async function fetchRun(url: string, name: string): Promise<LabRun> {
  const response = await fetch(url).catch(() => null);
  if (!response?.ok) throw new Error(`The reference ${name} cannot be fetched: reload the page.`);
  return parseRun(await response.text());
}

/** Reference runs, newest first. */
export const referenceRuns: readonly ReferenceRun[] = Object.keys(urls)
  .map((path) => {
    let run: Promise<LabRun> | null = null;
    const info = infos[path];
    return {
      info,
      read() {
        run ??= fetchRun(urls[path], info.name || info.label).catch((error: unknown) => {
          run = null;
          throw error;
        });
        return run;
      },
    };
  })
  .sort((a, b) => b.info.date.localeCompare(a.info.date));
