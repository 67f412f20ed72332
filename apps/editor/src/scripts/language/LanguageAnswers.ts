/** TypeScript declarations that scripts are checked against; made by `packages/tools/scriptDeclarations.mjs`. */
export interface ScriptDeclarations {
  readonly files: Readonly<Record<string, string>>;
  readonly modules: Readonly<Record<string, string>>;
  readonly globals: readonly string[];
}

export interface ScriptDiagnostic {
  readonly message: string;
  /** 'syntax' when the text cannot be parsed, 'types' for all other errors. */
  readonly kind: 'syntax' | 'types';
  readonly severity: 'error' | 'warning' | 'hint';
  /** Line of the problem in the script, from 1. */
  readonly line: number;
  /** Start of the error (characters from the start of the text); `to` is its end. */
  readonly from: number;
  readonly to: number;
}

/** A suggestion for completing a word. */
export interface ScriptCompletion {
  readonly label: string;
  /** TypeScript's kind: 'method', 'property', 'class' and so on. */
  readonly kind: string;
  /** Text to insert, when it differs from the label. */
  readonly insert?: string;
  /** Module to import the name from, when it is not imported yet. */
  readonly module?: string;
  /** Rank of the suggestion among equally good matches; a higher rank comes earlier. */
  readonly boost?: number;
}

export interface ScriptCompletions {
  /** Start of the word to complete (characters from the start of the text). */
  readonly from: number;
  readonly options: readonly ScriptCompletion[];
}

/** Type and documentation of a name. */
export interface ScriptHelp {
  readonly from: number;
  readonly to: number;
  readonly type: string;
  readonly help: string;
}

/** Signature of a function whose arguments are being written. */
export interface ScriptSignature {
  /** Start of the arguments (characters from the start of the text). */
  readonly from: number;
  readonly before: string;
  readonly parameters: readonly string[];
  readonly after: string;
  /** Index of the parameter that is being typed. */
  readonly active: number;
  readonly help: string;
  readonly parameterHelp: string;
}

/** Place in a script where a name is declared. */
export interface ScriptDefinition {
  readonly script: string;
  readonly line: number;
}

/** New text of a script; null for one that was removed. */
export type ScriptChange = readonly [name: string, text: string | null];

/** Queries of the language service, for a script and a position (characters from the start of the text). */
export interface LanguageQuestions {
  diagnostics(script: string): readonly ScriptDiagnostic[];
  completions(script: string, at: number, isAsked: boolean): ScriptCompletions | null;
  completionHelp(script: string, at: number, completion: ScriptCompletion): ScriptHelp | null;
  help(script: string, at: number): ScriptHelp | null;
  signature(script: string, at: number): ScriptSignature | null;
  definition(script: string, at: number): ScriptDefinition | null;
}
