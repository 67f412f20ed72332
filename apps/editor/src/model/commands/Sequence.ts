import type { Command, CommandSelection } from '@farol/editing';

/**
 * Several commands as one undo step: done in order, undone in reverse. Each may depend on the effects of earlier ones.
 */
export class Sequence implements Command {
  private commands: readonly Command[] | null = null;

  /**
   * @param make - creates the commands; each function is called after the command before was done
   * @param selection - ids to select afterwards
   */
  constructor(
    readonly label: string,
    private readonly make: readonly (() => Command)[],
    readonly selection?: CommandSelection,
  ) {}

  /** A sequence of commands that exist already. */
  static of(label: string, commands: readonly Command[]): Sequence {
    return new Sequence(
      label,
      commands.map((command) => () => command),
    );
  }

  /** The commands, once `do` has made them. */
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
