import { type Command, type CommandStack, type Gesture, Signal } from '@farol/editing';
import { type MicroShaderCompileEntry, MicroShaderCompileError } from '@farol/renderer/microshaders';
import type { ConsoleLog } from '../model/ConsoleLog';

/** Delay between the last key press and compiling (ms). */
const DELAY = 180;

/** Why an edited GLSL text is not in use: message, and the compiler's errors. */
export interface MicroShaderProblemText {
  readonly message: string;
  /** Compiler errors by microshader and line; empty when the text could not be parsed. */
  readonly entries: readonly MicroShaderCompileEntry[];
}

export function problemOf(error: unknown): MicroShaderProblemText {
  const message = error instanceof Error ? error.message : String(error);
  return { message, entries: error instanceof MicroShaderCompileError ? error.entries : [] };
}

/**
 * GLSL texts that are being typed, compiled once typing pauses. A text that compiles is previewed in a gesture of the
 * history, which `finish` commits; one that does not stays a draft with its problem. `Key` identifies the edited text.
 */
export abstract class TextDrafts<Key> {
  /** Emits when a text, a draft or a problem changes. */
  readonly changed = new Signal();

  protected readonly drafts = new Map<Key, string>();
  protected readonly problems = new Map<Key, MicroShaderProblemText>();
  private gesture: Gesture | null = null;
  private waiting: { readonly key: Key; readonly timer: ReturnType<typeof setTimeout> } | null = null;

  /** @param log - receives from `finish` the texts that do not compile */
  constructor(
    private readonly commands: () => CommandStack,
    protected readonly log: ConsoleLog,
  ) {}

  /** Compiles pending text at once. */
  flush(): void {
    if (!this.waiting) return;
    const { key, timer } = this.waiting;
    clearTimeout(timer);
    this.waiting = null;
    const text = this.drafts.get(key);
    // the edited item may have been removed
    if (text !== undefined) this.attemptText(key, text);
    this.changed.emit();
  }

  /** Ends editing: commits the preview as one step of history, and logs broken texts. */
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

  /** Notes typed text, which is compiled once typing pauses. */
  protected type(key: Key, text: string): void {
    if (this.waiting && this.waiting.key !== key) this.flush();
    if (this.waiting) clearTimeout(this.waiting.timer);
    this.drafts.set(key, text);
    this.waiting = { key, timer: setTimeout(() => this.flush(), DELAY) };
  }

  /**
   * Compiles a text.
   * @returns the command that sets it in the document; null when the document has it already
   * @throws the compiler's errors
   */
  protected abstract compile(key: Key, text: string): Command<unknown> | null;

  /** Name of the edited text in the console. */
  protected abstract chunkOf(key: Key): string;

  /** Name in the console of the microshader that has an error. */
  protected abstract chunkAt(key: Key, entry: MicroShaderCompileEntry): string;

  /** Whether a text is waiting to be compiled. */
  protected isWaiting(key: Key): boolean {
    return this.waiting?.key === key;
  }

  protected drop(key: Key): void {
    this.drafts.delete(key);
    this.problems.delete(key);
  }

  /** Called when another scene was opened: drops all drafts. */
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
