/** Everything that scripts are checked against; see `packages/tools/scriptDeclarations.mjs`. */
export interface ScriptDeclarations {
  readonly files: Readonly<Record<string, string>>;
  readonly modules: Readonly<Record<string, string>>;
  readonly globals: readonly string[];
}

/** What is wrong with a script. */
export interface ScriptDiagnostic {
  readonly message: string;
  /** Whether the text cannot be read, or is read and does not fit together. */
  readonly kind: 'syntax' | 'types';
  readonly severity: 'error' | 'warning' | 'hint';
  /** From 1. */
  readonly line: number;
  /** Characters from the start of the text. */
  readonly from: number;
  readonly to: number;
}

/** A word that may stand at a place. */
export interface ScriptCompletion {
  readonly label: string;
  /** TypeScript's kind: 'method', 'property', 'class' and so on. */
  readonly kind: string;
  /** What is put in, where it is not the label. */
  readonly insert?: string;
  /** Module that an import is added of. */
  readonly module?: string;
  /** Before others of the same fit when higher. */
  readonly boost?: number;
}

export interface ScriptCompletions {
  /** Where the word begins that is completed (characters from the start of the text). */
  readonly from: number;
  readonly options: readonly ScriptCompletion[];
}

/** A type, and what is said of it. */
export interface ScriptHelp {
  readonly from: number;
  readonly to: number;
  readonly type: string;
  readonly help: string;
}

/** How a function is called, at a place within its arguments. */
export interface ScriptSignature {
  /** Where its arguments begin. */
  readonly from: number;
  readonly before: string;
  readonly parameters: readonly string[];
  readonly after: string;
  /** Which parameter is being written. */
  readonly active: number;
  readonly help: string;
  readonly parameterHelp: string;
}

/** Where a name is declared, in a script of the scene. */
export interface ScriptDefinition {
  readonly script: string;
  readonly line: number;
}

/** Another text of a script; null for one that is gone. */
export type ScriptChange = readonly [name: string, text: string | null];

/** What can be asked of the service: of a script by its name, at a place (characters from the start of the text). */
export interface LanguageQuestions {
  diagnostics(script: string): readonly ScriptDiagnostic[];
  completions(script: string, at: number, isAsked: boolean): ScriptCompletions | null;
  completionHelp(script: string, at: number, completion: ScriptCompletion): ScriptHelp | null;
  help(script: string, at: number): ScriptHelp | null;
  signature(script: string, at: number): ScriptSignature | null;
  definition(script: string, at: number): ScriptDefinition | null;
}
