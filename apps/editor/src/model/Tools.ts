import { Signal } from '@farol/editing';

/** A tool shown over the viewport until it is completed or closed; one at a time. */
export interface Tool {
  /** Key of the tool's panel, see panels/viewport/tools. */
  readonly id: string;
  /** Ends the tool, and undoes an unfinished edit. Called once, also when another tool opens. */
  end(): void;
}

/** The tool that is open over the viewport. */
export class Tools {
  readonly changed = new Signal();

  private tool: Tool | null = null;

  get current(): Tool | null {
    return this.tool;
  }

  open(tool: Tool): void {
    this.end();
    this.tool = tool;
    this.changed.emit();
  }

  /** Ends the open tool, or does nothing when `tool` is another one. @returns whether a tool was ended */
  end(tool: Tool | null = this.tool): boolean {
    if (tool === null || tool !== this.tool) return false;
    this.tool = null;
    tool.end();
    this.changed.emit();
    return true;
  }
}
