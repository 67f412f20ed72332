import { parseMicroShader } from '@farol/renderer/microshaders';

/**
 * Microshaders of a scene: replacements of the renderer's chunks, and chunks of its own. The scene only stores them;
 * `MicroShaderOverrides` passes them to a renderer.
 */
export class SceneMicroShaders {
  private readonly byName = new Map<string, string>();

  /** @param changed - called after the text of the chunk `name` was set or removed */
  constructor(private readonly changed: (name: string) => void) {}

  /** GLSL texts of the microshaders, in the form of `.glsl` files, by chunk name. */
  get texts(): ReadonlyMap<string, string> {
    return this.byName;
  }

  /** The text of a chunk; undefined when the scene does not replace the renderer's. */
  get(name: string): string | undefined {
    return this.byName.get(name);
  }

  /** Sets the text of a chunk; null removes it. @throws Error for a name or a text that `parseMicroShader` refuses */
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
