import type { Command } from '@farol/editing';

/** Several commands as one step: done in order, undone in reverse. */
export class CommandList implements Command {
  constructor(
    readonly label: string,
    private readonly commands: readonly Command[],
  ) {}

  get isEmpty(): boolean {
    return this.commands.length === 0;
  }

  /** Runs all commands. @throws the error of a command, after undoing those before it */
  do(): void {
    let count = 0;
    try {
      for (; count < this.commands.length; count++) this.commands[count].do();
    } catch (error) {
      while (count-- > 0) this.commands[count].undo();
      throw error;
    }
  }

  undo(): void {
    for (const command of this.commands.toReversed()) command.undo();
  }

  forget(isDone: boolean): void {
    for (const command of this.commands) command.forget?.(isDone);
  }
}
