import type { Command, CommandSelection } from '@farol/editing';

/** Several commands as one step: done in order, undone backwards. Each may build on what those before it have done. */
export class Sequence implements Command {
  private commands: readonly Command[] | null = null;

  /**
   * @param make - makes the commands one by one, each to be done before the next is asked for
   * @param selection - what to select afterwards
   */
  constructor(
    readonly label: string,
    private readonly make: readonly (() => Command)[],
    readonly selection?: CommandSelection,
  ) {}

  /** The commands that were made so far, by doing it. */
  get parts(): readonly Command[] {
    return this.commands ?? [];
  }

  do(): void {
    const done: Command[] = [];
    try {
      for (let i = 0; i < this.make.length; i++) {
        const command = this.commands?.[i] ?? this.make[i]();
        command.do();
        done.push(command);
      }
    } catch (error) {
      for (const command of done.toReversed()) command.undo();
      throw error;
    }
    this.commands = done;
  }

  undo(): void {
    for (const command of (this.commands ?? []).toReversed()) command.undo();
  }

  forget(isDone: boolean): void {
    for (const command of this.commands ?? []) command.forget?.(isDone);
  }
}
