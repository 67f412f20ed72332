import { loopCheck } from './loopCheck';
import { resolveScript } from './resolveScript';
import type { ScriptFunction } from './CompiledScript';
import { ScriptError } from './ScriptError';
import { placeOfError } from './scriptUrl';

/** A script's exports, and the scripts that it imports. */
export interface ScriptModule {
  readonly name: string;
  readonly exports: Record<string, unknown>;
  readonly imports: ReadonlySet<string>;
}

const quotedList = (names: readonly string[]): string => names.map((name) => `'${name}'`).join(', ');

/** Runs scripts as modules, which import each other and the host's modules. */
export class ScriptModules {
  private readonly modules = new Map<string, ScriptModule>();
  /** Names of scripts whose text is running, the outermost first. */
  private readonly running: string[] = [];

  /**
   * @param functionOf - returns a script's function, or null for an unknown script; throws for a broken one
   * @param given - modules of the host, such as three, by name
   */
  constructor(
    private readonly functionOf: (name: string) => ScriptFunction | null,
    private readonly has: (name: string) => boolean,
    private readonly given: ReadonlyMap<string, unknown>,
  ) {}

  get(name: string): ScriptModule | undefined {
    return this.modules.get(name);
  }

  forget(name: string): void {
    this.modules.delete(name);
  }

  restore(module: ScriptModule): void {
    this.modules.set(module.name, module);
  }

  /** The given scripts, and all scripts that import one of them, directly or indirectly. */
  dependentsOf(names: Iterable<string>): Set<string> {
    const found = new Set(names);
    for (const name of found) {
      for (const module of this.modules.values()) if (module.imports.has(name)) found.add(module.name);
    }
    return found;
  }

  /**
   * The module of a script, which runs on the first call.
   * @throws ScriptError when the script, or one that it imports, fails
   */
  load(name: string): ScriptModule {
    const known = this.modules.get(name);
    if (known) return known;
    const run = this.functionOf(name);
    if (!run) throw new ScriptError(name, 'there is no such script: create it, or correct the name.');
    const imports = new Set<string>();
    const holder: { exports: Record<string, unknown> } = { exports: {} };
    this.running.push(name);
    try {
      run((specifier) => this.require(specifier, name, imports), holder.exports, holder, loopCheck);
    } catch (error) {
      throw asScriptError(error, name);
    } finally {
      this.running.pop();
    }
    const module = { name, exports: holder.exports, imports };
    this.modules.set(name, module);
    return module;
  }

  private require(specifier: string, from: string, imports: Set<string>): unknown {
    const given = this.given.get(specifier);
    if (given) return given;
    const fail = (problem: string): never => {
      const place = placeOfError(new Error(problem), [from]);
      throw new ScriptError(from, problem, place?.line ?? 0, place?.column ?? 0);
    };
    if (!specifier.startsWith('.')) {
      return fail(
        `it imports '${specifier}', which is not there: scripts can import ${quotedList([...this.given.keys()])}, and other scripts as './name'.`,
      );
    }
    const name = resolveScript(specifier, from, this.has);
    if (name === null)
      return fail(`it imports '${specifier}', and there is no such script: create it, or correct the name.`);
    imports.add(name);
    if (this.running.includes(name)) {
      const ring = [...this.running.slice(this.running.indexOf(name)), name].join(' imports ');
      return fail(`it imports itself in a circle: ${ring}. Move what they share to a script of its own.`);
    }
    return this.load(name).exports;
  }
}

/** Wraps a value that a script threw into a ScriptError that names its position. */
export function asScriptError(error: unknown, script: string): ScriptError {
  if (error instanceof ScriptError) return error;
  const place = placeOfError(error, [script]);
  const problem = error instanceof Error ? error.message : String(error);
  return new ScriptError(place?.script ?? script, problem, place?.line ?? 0, place?.column ?? 0, { cause: error });
}
