/** A script compiled to JavaScript: a function in the form of a CommonJS module. */
export interface CompiledScript {
  /** Name of the script asset. */
  readonly name: string;
  /** Source text from which the script was compiled. */
  readonly source: string;
  /**
   * JavaScript text of a classic script, which stores the script's function in `globalThis.farolScripts` under its
   * name. Lines are numbered as in the source, and stack traces name the script as `scriptUrl` does.
   */
  readonly code: string;
}

/**
 * Runs the text of a script, which adds its exports to `exports`.
 * @param check - throws when a loop has run for too long
 */
export type ScriptFunction = (
  require: (specifier: string) => unknown,
  exports: Record<string, unknown>,
  module: { exports: Record<string, unknown> },
  check: () => void,
) => void;

/** Returns the function of a compiled script. @throws ScriptError for invalid JavaScript */
export type ScriptRunner = (script: CompiledScript) => ScriptFunction | Promise<ScriptFunction>;
