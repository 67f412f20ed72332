/** Position in a script. */
export interface ScriptPlace {
  /** Name of the script asset. */
  readonly script: string;
  /** Line number from 1; 0 when unknown. */
  readonly line: number;
  /** Column number from 1; 0 when unknown. */
  readonly column: number;
}

/** Error in a script's text or module; the message names script, line and remedy. */
export class ScriptError extends Error implements ScriptPlace {
  override readonly name = 'ScriptError';

  constructor(
    readonly script: string,
    /** The problem, without the name of the script. */
    readonly problem: string,
    readonly line: number = 0,
    readonly column: number = 0,
    options?: ErrorOptions,
  ) {
    super(`${script}${line > 0 ? `, line ${line}` : ''}: ${problem}`, options);
  }
}
