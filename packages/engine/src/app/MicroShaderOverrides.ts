import type { MicroShader, MicroShaderRegistry } from '@farol/renderer/authoring';

/** A microshader of a scene that a renderer refused; the previous text stays in use. */
export interface MicroShaderProblem {
  readonly name: string;
  /** A MicroShaderCompileError where a shader did not compile. */
  readonly error: Error;
}

const asError = (error: unknown): Error => (error instanceof Error ? error : new Error(String(error)));

/** Applies the microshaders of scenes (`scene.microShaders.texts`) to the registry of one renderer. */
export class MicroShaderOverrides {
  /** Texts of the scene that are in the registry now, by chunk name. */
  private readonly applied = new Map<string, string>();
  /**
   * The registry's own microshaders (not its parent's) that texts of the scene replace, by name: chunks of effects,
   * such as shadows.
   */
  private readonly replaced = new Map<string, MicroShader>();

  constructor(readonly registry: MicroShaderRegistry) {}

  /**
   * Registers these texts, and restores the registry's own chunks under all other names.
   * @returns texts that the registry refused; all others are in use
   */
  apply(wanted: ReadonlyMap<string, string>): MicroShaderProblem[] {
    const { registry, applied } = this;
    const problems: MicroShaderProblem[] = [];
    const attempt = (name: string, change: () => void): void => {
      try {
        change();
      } catch (error) {
        problems.push({ name, error: asError(error) });
      }
    };
    const changed = [...wanted].filter(([name, text]) => applied.get(name) !== text);
    // new chunks first: replaced chunks may include them
    for (const isNew of [true, false]) {
      for (const [name, text] of changed) {
        if (registry.has(name) === isNew || applied.get(name) === text) continue;
        attempt(name, () => {
          if (!isNew) return this.replace(name, text);
          registry.loadGLSL(name, text, true);
          applied.set(name, text);
        });
      }
    }
    for (const [name, error] of this.takeOut(wanted)) problems.push({ name, error });
    return problems;
  }

  /** Chunk names, each before the chunks that it includes; in the given order if there is a cycle. */
  private usersFirst(names: readonly string[]): string[] {
    const users = new Map(names.map((name) => [name, 0]));
    const needed = (name: string): string[] =>
      (this.registry.get(name)?.dependencies ?? []).filter((each) => users.has(each));
    for (const name of names) for (const each of needed(name)) users.set(each, users.get(each)! + 1);
    const order = names.filter((name) => users.get(name) === 0);
    // `order` grows while it is iterated
    for (const name of order) {
      for (const each of needed(name)) {
        const left = users.get(each)! - 1;
        users.set(each, left);
        if (left === 0) order.push(each);
      }
    }
    return order.length === names.length ? order : [...names];
  }

  /**
   * Removes texts that are no longer wanted; a chunk that another includes is removed after that other.
   * @returns chunks that cannot be removed, with the reason
   */
  private takeOut(wanted: ReadonlyMap<string, string>): Map<string, Error> {
    const refused = new Map<string, Error>();
    const order = this.usersFirst([...this.applied.keys()].filter((name) => !wanted.has(name)));
    let isDone = false;
    while (!isDone) {
      isDone = true;
      refused.clear();
      for (const name of order) {
        if (!this.applied.has(name)) continue;
        try {
          const before = this.replaced.get(name);
          if (before) this.registry.replace(name, before);
          else this.registry.remove(name);
          this.replaced.delete(name);
          this.applied.delete(name);
          isDone = false;
        } catch (error) {
          refused.set(name, asError(error));
        }
      }
    }
    return refused;
  }

  /**
   * Replaces the text of a registered chunk.
   * @throws as `MicroShaderRegistry.replace` does; nothing has changed then
   */
  replace(name: string, text: string): void {
    const before = this.applied.has(name) || this.registry.original(name) ? undefined : this.registry.get(name);
    this.registry.replace(name, text);
    if (before) this.replaced.set(name, before);
    this.applied.set(name, text);
  }

  /** The renderer's chunk of a name, before the scene's text; undefined for a chunk that only the scene has. */
  originalOf(name: string): MicroShader | undefined {
    const own = this.applied.has(name) ? undefined : this.registry.get(name);
    return this.registry.original(name) ?? this.replaced.get(name) ?? own;
  }
}
