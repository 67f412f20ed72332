import { type FieldTable, type FieldValue, string } from '@farol/editing/fields';
import type { Surface } from '@farol/renderer/surfaces';
import { DataAsset, type FieldAssetHost } from './FieldAsset';
import { surfaceCode } from './surfaceCode';
import { uniformFieldsOf } from './uniformFields';

export const surfaceFields = {
  source: string('', { help: 'Text: GLSL with surface() or displace(), and its uniforms.' }),
};

const none: FieldTable = {};

/** Part of an AssetLibrary that SurfaceAsset uses. */
export interface SurfaceHost extends FieldAssetHost {
  /** Time (s) of the scene, which all surfaces of the library share. */
  readonly surfaceTime: { value: number };
  /** @internal Called when `surface` or its uniforms changed. */
  surfaceChanged(asset: SurfaceAsset, problem: Error | null): void;
}

/**
 * A surface of a library: GLSL on top of materials, which changes position, normal, colour, roughness, metalness and
 * emissive light. While a text cannot be compiled, the last good one stays in use.
 */
export class SurfaceAsset extends DataAsset {
  static readonly fields = surfaceFields;
  override readonly type = 'surface';

  /** Error of the present text; null while the text is in use. */
  problem: Error | null = null;
  private made: Surface | null = null;
  private table: FieldTable = {};
  private readonly surfaceHost: SurfaceHost;

  /** @throws FieldError for a value that is not allowed */
  constructor(host: SurfaceHost, name: string, values: Readonly<Record<string, FieldValue>> = {}) {
    super(host, name, values);
    this.surfaceHost = host;
  }

  /** GLSL text of the surface. */
  get source(): string {
    return this.get('source') as string;
  }

  /**
   * The compiled surface for materials; null until the renderer's late code is loaded, and while no text has compiled.
   */
  get surface(): Surface | null {
    return this.made;
  }

  /**
   * Fields of objects with this surface, by uniform name: numbers, colours, vectors and textures, see `uniformFieldsOf`.
   * Empty while the text does not compile, so that the fields depend on the text alone and undo finds those it recorded.
   */
  get uniformFields(): FieldTable {
    return this.problem ? none : this.table;
  }

  /** @internal Uniform fields of `surface`, which may be of an earlier text. */
  get surfaceFields(): FieldTable {
    return this.table;
  }

  /** @internal Compiles the text, once the asset is in its library. */
  begin(): void {
    if (surfaceCode.code) this.refresh();
    else
      surfaceCode.load().then(
        () => this.refresh(),
        (error: Error) => this.surfaceHost.surfaceChanged(this, error),
      );
  }

  protected override fieldChanged(name: string, before: FieldValue): void {
    this.refresh();
    super.fieldChanged(name, before);
  }

  private refresh(): void {
    const code = surfaceCode.code;
    // during construction the library does not know the asset yet
    if (!code || !this.surfaceHost) return;
    const before = this.problem;
    this.problem = null;
    try {
      if (this.made) this.made.source = this.source;
      else this.made = new code.Surface(this.name, this.source, { time: this.surfaceHost.surfaceTime });
      this.made.name = this.name;
      this.table = uniformFieldsOf(this.made.uniforms);
    } catch (error) {
      this.problem = error as Error;
    }
    this.surfaceHost.surfaceChanged(this, this.problem?.message === before?.message ? null : this.problem);
  }
}
