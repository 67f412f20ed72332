import type { Command } from './Command';

/**
 * An edit under way, such as a drag: any number of previews, each replacing the last, then one commit or discard. See
 * `CommandStack.begin`.
 */
export class Gesture<Item = string> {
  private current: Command<Item> | null = null;
  private open = true;

  /**
   * @param finish - called with the command of a committed gesture; null when nothing changed
   * @param instead - replaces each command before it is run, see `EditRecorder`
   */
  constructor(
    private readonly finish: (command: Command<Item> | null) => void,
    private readonly instead: (command: Command<Item>) => Command<Item> = (command) => command,
  ) {}

  /** Whether the gesture is under way: neither committed nor discarded. Calls do nothing otherwise. */
  get isOpen(): boolean {
    return this.open;
  }

  /**
   * Runs a command in place of the last preview.
   * @throws the command's error; the document is then as at the start
   */
  preview(asked: Command<Item>): void {
    if (!this.open) return;
    const command = this.instead(asked);
    const before = this.current;
    const joined = before?.replaceWith?.(command) ?? null;
    if (joined) {
      this.current = joined;
      return;
    }
    this.reset();
    command.do();
    this.current = command;
  }

  /**
   * Reverts the last preview; the gesture continues. Call it before making a command that depends on more of the scene
   * than the fields it sets, such as one that deletes or moves objects.
   */
  reset(): void {
    if (!this.open || !this.current) return;
    const before = this.current;
    this.current = null;
    before.undo();
    before.forget?.(false);
  }

  /** Keeps the last preview as one step of history. */
  commit(): void {
    if (!this.open) return;
    this.open = false;
    this.finish(this.current && !this.current.isEmpty ? this.current : null);
  }

  /** Restores the document's state from the start of the gesture. */
  discard(): void {
    if (!this.open) return;
    this.reset();
    this.open = false;
    this.finish(null);
  }
}
