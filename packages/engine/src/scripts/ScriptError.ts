/** Where in a script something is. */
export interface ScriptPlace {
  /** Name of the script asset. */
  readonly script: string;
  /** From 1; 0 where it is not known. */
  readonly line: number;
  /** From 1; 0 where it is not known. */
  readonly column: number;
}

/** What is wrong with the text of a script, or with the module that it makes: the message names script, line and mend. */
export class ScriptError extends Error implements ScriptPlace {
  override readonly name = 'ScriptError';

  constructor(
    readonly script: string,
    /** What is wrong, without the name of the script. */
    readonly problem: string,
    readonly line: number = 0,
    readonly column: number = 0,
    options?: ErrorOptions,
  ) {
    super(`${script}${line > 0 ? `, line ${line}` : ''}: ${problem}`, options);
  }
}
