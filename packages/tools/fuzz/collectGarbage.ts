import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';

setFlagsFromString('--expose-gc');

const collect = runInNewContext('gc') as () => void;

/** Collects all garbage, also in a thread that was started without `--expose-gc`. */
export function collectGarbage(): void {
  collect();
  // the memory of array buffers is given back beside the program; the next collection waits for that
  collect();
}
