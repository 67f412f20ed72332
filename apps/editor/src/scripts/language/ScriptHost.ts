import ts from 'typescript-in-browser';
import type { ScriptChange, ScriptDeclarations } from './LanguageAnswers';

const FOLDER = '/scripts/';

const options: ts.CompilerOptions = {
  target: ts.ScriptTarget.ES2022,
  module: ts.ModuleKind.ESNext,
  moduleResolution: ts.ModuleResolutionKind.Bundler,
  moduleDetection: ts.ModuleDetectionKind.Force,
  lib: ['lib.es2023.d.ts', 'lib.dom.d.ts', 'lib.dom.iterable.d.ts'],
  strict: true,
  // methods called by events may omit the types of their parameters
  noImplicitAny: false,
  isolatedModules: true,
  allowJs: true,
  noEmit: true,
  skipLibCheck: true,
  types: [],
};

interface ScriptText {
  readonly text: string;
  readonly version: number;
}

/** Path of a script for TypeScript. */
export const fileOfScript = (name: string): string => FOLDER + name + (/\.[jt]s$/i.test(name) ? '' : '.ts');

const resolved = (path: string): ts.ResolvedModuleWithFailedLookupLocations => ({
  resolvedModule: { resolvedFileName: path, extension: ts.Extension.Dts, isExternalLibraryImport: true },
});

/**
 * Host of the language service: files are the scripts of a scene, and the declarations that they are checked against.
 */
export class ScriptHost implements ts.LanguageServiceHost {
  /** Texts of scripts by path. */
  private readonly texts = new Map<string, ScriptText>();
  private readonly names = new Map<string, string>();
  private readonly snapshots = new Map<string, ts.IScriptSnapshot>();
  private revision = 0;

  constructor(private readonly declarations: ScriptDeclarations) {}

  /** Adds, replaces or removes texts of scripts. */
  change(changes: readonly ScriptChange[]): void {
    for (const [name, text] of changes) {
      const file = fileOfScript(name);
      this.revision++;
      this.snapshots.delete(file);
      if (text === null) {
        this.texts.delete(file);
        this.names.delete(file);
      } else {
        this.texts.set(file, { text, version: this.revision });
        this.names.set(file, name);
      }
    }
  }

  /** Name of the script at a path; null for declarations. */
  scriptOf(file: string): string | null {
    return this.names.get(file) ?? null;
  }

  textOf(file: string): string {
    return this.texts.get(file)?.text ?? '';
  }

  /** Names of the scripts, each with its path. */
  get scripts(): ReadonlyMap<string, string> {
    return new Map([...this.names].map(([file, name]) => [name, file]));
  }

  getCompilationSettings(): ts.CompilerOptions {
    return options;
  }

  getProjectVersion(): string {
    return String(this.revision);
  }

  getScriptFileNames(): string[] {
    // all modules are included, also those that no script imports yet, so that completion knows them
    const { globals, modules } = this.declarations;
    return [...globals, ...Object.values(modules), ...this.texts.keys()];
  }

  getScriptVersion(file: string): string {
    return String(this.texts.get(file)?.version ?? 0);
  }

  getScriptSnapshot(file: string): ts.IScriptSnapshot | undefined {
    let snapshot = this.snapshots.get(file);
    if (snapshot) return snapshot;
    const text = this.readFile(file);
    if (text === undefined) return undefined;
    snapshot = ts.ScriptSnapshot.fromString(text);
    this.snapshots.set(file, snapshot);
    return snapshot;
  }

  getCurrentDirectory(): string {
    return FOLDER;
  }

  getDefaultLibFileName(): string {
    return '/lib/lib.es2023.d.ts';
  }

  fileExists(file: string): boolean {
    return this.texts.has(file) || file in this.declarations.files;
  }

  readFile(file: string): string | undefined {
    return this.texts.get(file)?.text ?? this.declarations.files[file];
  }

  resolveModuleNameLiterals(
    literals: readonly ts.StringLiteralLike[],
    from: string,
  ): readonly ts.ResolvedModuleWithFailedLookupLocations[] {
    return literals.map(({ text }) => this.resolve(text, from));
  }

  private resolve(specifier: string, from: string): ts.ResolvedModuleWithFailedLookupLocations {
    const path = this.declarations.modules[specifier];
    if (path !== undefined) return resolved(path);
    if (!specifier.startsWith('.')) return { resolvedModule: undefined };
    const place = new URL(specifier, `file://${from}`).pathname;
    const target = decodeURIComponent(place);
    if (from.startsWith(FOLDER)) {
      const file = [target, `${target}.ts`, `${target}.js`].find((each) => this.texts.has(each));
      if (file === undefined) return { resolvedModule: undefined };
      const extension = file.endsWith('.js') ? ts.Extension.Js : ts.Extension.Ts;
      return { resolvedModule: { resolvedFileName: file, extension, isExternalLibraryImport: false } };
    }
    const files = [target.replace(/\.js$/, '.d.ts'), `${target}.d.ts`, `${target}/index.d.ts`];
    const file = files.find((each) => each.endsWith('.d.ts') && each in this.declarations.files);
    return file === undefined ? { resolvedModule: undefined } : resolved(file);
  }
}
