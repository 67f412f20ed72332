import { Signal } from '@farol/editing';

/** Something that is open over the picture until it is done or left: one at a time. */
export interface Tool {
  /** What is shown for it: see panels/viewport/tools. */
  readonly id: string;
  /** Leaves it; what it has not finished is put back. Called once, also where something else takes its place. */
  end(): void;
}

/** The tool that is open over the picture. */
export class Tools {
  /** Emits when a tool opens or ends. */
  readonly changed = new Signal();

  private tool: Tool | null = null;

  get current(): Tool | null {
    return this.tool;
  }

  /** Opens a tool in place of the one that is open. */
  open(tool: Tool): void {
    this.end();
    this.tool = tool;
    this.changed.emit();
  }

  /** Ends the tool that is open, or this one if it is. @returns whether there was one */
  end(tool: Tool | null = this.tool): boolean {
    if (tool === null || tool !== this.tool) return false;
    this.tool = null;
    tool.end();
    this.changed.emit();
    return true;
  }
}
