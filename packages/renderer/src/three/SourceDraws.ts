import { type BufferGeometry, type Camera, Material, type Object3D, type Scene, type WebGLRenderer } from 'three';
import type { DirectDraw } from './directDraw';
import type { GeometryGroup } from './RenderListItem';
import { materialRecord, type MaterialRecord } from './handles';

/** Thrown out of three's draw where three is about to look for another program. */
const NEEDS_PROGRAM = new Error('Farol: three needs another program.');

const { onBeforeRender } = Material.prototype;

/** Properties of a twin that three reads for programs, or for the fog of a scene that has one. */
const WITHOUT_FOG = new Set(['fog', 'dithering']);

/**
 * Draws with a host's material by the programs and uniforms of its twin. A twin has a shape of its own, since the host's
 * material is its prototype, and three reads some sixty properties a draw: of many shapes they are slow to read. Here three
 * reads the host's material, and finds the twin's record under it.
 */
export class SourceDraws {
  /** Material that is being drawn, and the record of its twin; null outside of `draw`. */
  private source: Material | null = null;
  private record: MaterialRecord | null = null;
  /** Twin that `isFit` was found for; null when it must be found anew. */
  private twin: Material | null = null;
  private isFit = false;
  private properties: WebGLRenderer['properties'] | null = null;
  private getRecord!: WebGLRenderer['properties']['get'];
  private getTarget!: WebGLRenderer['getRenderTarget'];

  constructor(
    private readonly webgl: WebGLRenderer,
    private readonly direct: DirectDraw,
  ) {}

  /** Looks again whether twins fit: a callback of the host's may have changed them. */
  forget(): void {
    this.twin = null;
  }

  /**
   * Draws as `direct` would with the twin.
   * @param properties - properties that the twin has in place of its source's
   * @returns false where it could not, and the twin is to be drawn
   */
  draw(
    camera: Camera,
    scene: Scene,
    geometry: BufferGeometry,
    source: Material,
    twin: Material,
    properties: object | undefined,
    object: Object3D,
    group: GeometryGroup | null,
  ): boolean {
    if (twin !== this.twin) this.look(scene, source, twin, properties);
    if (!this.isFit) return false;
    if (this.properties === null) this.begin();
    this.source = source;
    try {
      this.direct(camera, scene, geometry, source, object, group);
      return true;
    } catch (error) {
      if (error !== NEEDS_PROGRAM) throw error;
      // has three look for the program at the draw of the twin
      this.record!.__version = -1;
      this.twin = null;
      return false;
    } finally {
      this.source = null;
    }
  }

  /** Ends a frame: three's functions are as before. */
  end(): void {
    const { properties, webgl } = this;
    this.twin = this.record = this.properties = null;
    if (properties === null) return;
    if (properties.get === this.get) properties.get = this.getRecord;
    if (webgl.getRenderTarget === this.target) webgl.getRenderTarget = this.getTarget;
  }

  private look(scene: Scene, source: Material, twin: Material, properties: object | undefined): void {
    this.twin = twin;
    this.isFit = source.onBeforeRender === onBeforeRender && twin.version === source.version;
    if (properties !== undefined)
      this.isFit &&= (scene.fog ?? null) === null && Object.keys(properties).every((name) => WITHOUT_FOG.has(name));
    if (!this.isFit) return;
    this.record = materialRecord(this.webgl, twin);
    this.isFit = this.record.currentProgram !== undefined;
  }

  private begin(): void {
    const { webgl } = this;
    const { properties } = webgl;
    this.properties = properties;
    this.getRecord = properties.get;
    this.getTarget = webgl.getRenderTarget;
    properties.get = this.get;
    webgl.getRenderTarget = this.target;
  }

  private readonly get = (object: unknown): unknown => (object === this.source ? this.record : this.getRecord(object));

  /** Called by three before it makes or looks up a program, and by the host. */
  private readonly target: WebGLRenderer['getRenderTarget'] = () => {
    if (this.source !== null) throw NEEDS_PROGRAM;
    return this.getTarget.call(this.webgl);
  };
}
