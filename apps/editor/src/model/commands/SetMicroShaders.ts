import type { Command } from '@farol/editing';
import type { Scene } from '@farol/engine';

/** A microshader of a scene, and its new text; null restores the renderer's own, or removes it. */
export interface MicroShaderEdit {
  readonly name: string;
  readonly text: string | null;
}

/** Sets texts of microshaders, or removes them. */
export class SetMicroShaders implements Command {
  /** Texts before the first `do`. */
  private before: readonly MicroShaderEdit[] | null = null;

  /** @param edits - each name at most once; texts must be valid for `parseMicroShader` */
  constructor(
    readonly label: string,
    private readonly scene: Scene,
    private readonly edits: readonly MicroShaderEdit[],
  ) {}

  get isEmpty(): boolean {
    const before = this.before ?? this.current();
    return this.edits.every(({ text }, i) => text === before[i].text);
  }

  do(): void {
    this.before ??= this.current();
    this.set(this.edits);
  }

  undo(): void {
    this.set(this.before!.toReversed());
  }

  replaceWith(next: Command): Command | null {
    if (!(next instanceof SetMicroShaders) || next.scene !== this.scene) return null;
    const isSame =
      next.edits.length === this.edits.length && next.edits.every(({ name }, i) => name === this.edits[i].name);
    if (!isSame) return null;
    this.set(next.edits);
    next.before = this.before;
    return next;
  }

  private current(): MicroShaderEdit[] {
    return this.edits.map(({ name }) => ({ name, text: this.scene.microShaders.get(name) ?? null }));
  }

  private set(edits: readonly MicroShaderEdit[]): void {
    for (const { name, text } of edits) this.scene.microShaders.set(name, text);
  }
}
