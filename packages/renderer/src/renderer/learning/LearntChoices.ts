/** Key of `localStorage`. */
const KEY = 'farol-learnt';
/** Version of keys and values: raise it when techniques, keys or costs change, so that all is learnt anew. */
const VERSION = 2;
/** Maximum number of entries of one GPU (about 4 kB), and maximum number of GPUs. */
const ENTRIES = 256;
const GPUS = 4;

/** Verdict on a pair of techniques: the index of the faster one (0 or 1), or TIE. */
export type Verdict = 0 | 1 | 2;
export const TIE = 2;

/** Storage of texts by key, such as `localStorage`; it may throw. */
export type Storage = Pick<globalThis.Storage, 'getItem' | 'setItem' | 'removeItem'>;

interface Stored {
  readonly version: number;
  readonly gpus: Record<string, readonly (readonly [key: number, verdict: number])[]>;
}

/** Verdicts learnt on one GPU, by key, kept in a storage from visit to visit. */
export class LearntChoices {
  private readonly verdicts = new Map<number, Verdict>();

  /** @param storage - null: nothing is kept */
  constructor(
    readonly gpu: string,
    private readonly storage: Storage | null,
  ) {
    for (const [key, verdict] of this.read().gpus[gpu] ?? []) this.verdicts.set(key, verdict as Verdict);
  }

  get size(): number {
    return this.verdicts.size;
  }

  get(key: number): Verdict | undefined {
    return this.verdicts.get(key);
  }

  /** Stores a verdict, in place of the oldest one where there are too many. */
  set(key: number, verdict: Verdict): void {
    const { gpu, verdicts } = this;
    verdicts.delete(key);
    verdicts.set(key, verdict);
    if (verdicts.size > ENTRIES) verdicts.delete(verdicts.keys().next().value!);
    const { [gpu]: _, ...others } = this.read().gpus;
    const kept = Object.entries(others).slice(1 - GPUS);
    const stored: Stored = { version: VERSION, gpus: { ...Object.fromEntries(kept), [gpu]: [...verdicts] } };
    try {
      this.storage?.setItem(KEY, JSON.stringify(stored));
    } catch {
      // storage is full or forbidden: verdicts last as long as the page
    }
  }

  /** Stored verdicts of all GPUs, and those of this one. */
  all(): [gpu: string, key: number, verdict: Verdict][] {
    const gpus = { ...this.read().gpus, ...(this.size > 0 && { [this.gpu]: [...this.verdicts] }) };
    return Object.entries(gpus).flatMap(([gpu, list]) =>
      list.map(([key, verdict]): [string, number, Verdict] => [gpu, key, verdict as Verdict]),
    );
  }

  /** Forgets the verdicts of all GPUs. */
  clear(): void {
    this.verdicts.clear();
    try {
      this.storage?.removeItem(KEY);
    } catch {
      // storage is forbidden: nothing is stored
    }
  }

  /** Stored verdicts; none if the stored text has another version or form. */
  private read(): Stored {
    try {
      const stored = JSON.parse(this.storage?.getItem(KEY) ?? 'null') as Stored | null;
      if (stored?.version === VERSION && Object.values(stored.gpus).every((list) => list.every(isEntry))) return stored;
    } catch {
      // the text was not written by this class
    }
    return { version: VERSION, gpus: {} };
  }
}

const isEntry = ([key, verdict]: readonly [unknown, unknown]): boolean =>
  Number.isSafeInteger(key) && (verdict === 0 || verdict === 1 || verdict === TIE);
