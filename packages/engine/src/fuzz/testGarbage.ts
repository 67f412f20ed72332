import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';

setFlagsFromString('--expose-gc');

/** Collects all garbage, also in a thread that was started without `--expose-gc`. */
export const collectGarbage = runInNewContext('gc') as () => void;
