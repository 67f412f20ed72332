import { type Command, type CommandStack, type Gesture, Signal } from '@farol/editing';
import { type MicroShaderCompileEntry, MicroShaderCompileError } from '@farol/renderer/microshaders';
import type { ConsoleLog } from '../model/ConsoleLog';

/** How long after the last key a text is compiled (ms). */
const DELAY = 180;

/** Why a text is not in use. */
export interface MicroShaderProblemText {
  readonly message: string;
  /** By chunk and line; none where the text cannot even be read. */
  readonly entries: readonly MicroShaderCompileEntry[];
}

export function problemOf(error: unknown): MicroShaderProblemText {
  const message = error instanceof Error ? error.message : String(error);
  return { message, entries: error instanceof MicroShaderCompileError ? error.entries : [] };
}

/**
 * GLSL texts that are typed, by what they are of: compiled once no key follows. What compiles is previewed in a gesture of the
 * history, which `finish` makes one step; what does not stays a draft with its problem.
 */
export abstract class TextDrafts<Key> {
  /** Emits when a text, a draft or a problem changes. */
  readonly changed = new Signal();

  protected readonly drafts = new Map<Key, string>();
  protected readonly problems = new Map<Key, MicroShaderProblemText>();
  private gesture: Gesture | null = null;
  private waiting: { readonly key: Key; readonly timer: ReturnType<typeof setTimeout> } | null = null;

  /** @param log - is told, by `finish`, of what is broken */
  constructor(
    private readonly commands: () => CommandStack,
    protected readonly log: ConsoleLog,
  ) {}

  /** Compiles what waits to be. */
  flush(): void {
    if (!this.waiting) return;
    const { key, timer } = this.waiting;
    clearTimeout(timer);
    this.waiting = null;
    const text = this.drafts.get(key);
    // what it was of may be gone
    if (text !== undefined) this.attemptText(key, text);
    this.changed.emit();
  }

  /** The user turned elsewhere: what was edited is one step of history, and what is broken is told. */
  finish(): void {
    this.flush();
    this.gesture?.commit();
    this.gesture = null;
    for (const [key, { message, entries }] of this.problems) {
      const chunk = this.chunkOf(key);
      if (entries.length === 0) this.log.add('error', 'shader', message, { chunk, line: 1 });
      for (const entry of entries)
        this.log.add('error', 'shader', entry.message, { chunk: this.chunkAt(key, entry), line: entry.line });
    }
  }

  /** A key was pressed: compiles the text once no more follow. */
  protected type(key: Key, text: string): void {
    if (this.waiting && this.waiting.key !== key) this.flush();
    if (this.waiting) clearTimeout(this.waiting.timer);
    this.drafts.set(key, text);
    this.waiting = { key, timer: setTimeout(() => this.flush(), DELAY) };
  }

  /**
   * Tries a text on the device.
   * @returns the edit of the document; null where it has the text
   * @throws what is wrong with it
   */
  protected abstract compile(key: Key, text: string): Command<unknown> | null;

  /** What the console calls it. */
  protected abstract chunkOf(key: Key): string;

  /** What the console calls the chunk of an error. */
  protected abstract chunkAt(key: Key, entry: MicroShaderCompileEntry): string;

  /** Whether a text of it waits to be compiled. */
  protected isWaiting(key: Key): boolean {
    return this.waiting?.key === key;
  }

  protected drop(key: Key): void {
    this.drafts.delete(key);
    this.problems.delete(key);
  }

  /** Another scene came. */
  protected forget(): void {
    if (this.waiting) clearTimeout(this.waiting.timer);
    this.waiting = null;
    this.gesture = null;
    this.drafts.clear();
    this.problems.clear();
  }

  private attemptText(key: Key, text: string): void {
    try {
      const command = this.compile(key, text);
      this.drop(key);
      if (command) this.preview(command);
    } catch (error) {
      this.problems.set(key, problemOf(error));
    }
  }

  private preview(command: Command<unknown>): void {
    if (!this.gesture?.isOpen) this.gesture = this.commands().begin();
    this.gesture.preview(command as Command);
  }
}
