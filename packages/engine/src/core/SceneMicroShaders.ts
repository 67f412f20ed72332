import { parseMicroShader } from '@farol/renderer/microshaders';

/**
 * The microshaders that belong to a scene: texts in place of the renderer's own, and chunks that it adds. The scene only
 * keeps them; `MicroShaderOverrides` brings them into a renderer.
 */
export class SceneMicroShaders {
  private readonly byName = new Map<string, string>();

  /** @param changed - called after a text was set or taken out */
  constructor(private readonly changed: (name: string) => void) {}

  /** Texts in the form of `.glsl` files, by name. */
  get texts(): ReadonlyMap<string, string> {
    return this.byName;
  }

  /** The text of a chunk; undefined where the renderer's own stands. */
  get(name: string): string | undefined {
    return this.byName.get(name);
  }

  /** Sets the text of a chunk, or takes it out. @throws Error for a name or a text that `parseMicroShader` refuses */
  set(name: string, text: string | null): void {
    if (text === (this.byName.get(name) ?? null)) return;
    if (text === null) this.byName.delete(name);
    else {
      parseMicroShader(name, text);
      this.byName.set(name, text);
    }
    this.changed(name);
  }
}
