import {
  FloatType,
  HalfFloatType,
  type IUniform,
  Matrix4,
  NearestFilter,
  RedFormat,
  type Texture,
  Vector3,
  Vector4,
  WebGLRenderTarget,
} from 'three';
import type { Frame } from '../frame/Frame';
import { FullscreenPass } from '../gpu/FullscreenPass';
import type { LightField } from './LightField';
import { fieldCount } from '../lights/lightData';
import { viewFrustumPlanes } from '../lights/spheres';
import type { FieldDepths } from './FieldDepths';

/** Bytes of a light: three texels of 32-bit floats, and its cell. */
const BYTES = 3 * 16 + 2;

const planes = new Float64Array(24);

/** Textures that hold the lights of a field, all of one size, `width` texels a row. */
export interface FieldSources {
  sphere: Texture | null;
  emission: Texture | null;
  cone: Texture | null;
  width: number;
}

/** The lights of a frame's fields in view space, a texel for each light; each field begins with a new row. */
export class FieldLights {
  readonly target: WebGLRenderTarget = new WebGLRenderTarget(128, 1, {
    count: 4,
    type: FloatType,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    depthBuffer: false,
  });
  private readonly uniforms = {
    farol_fieldSpheres: { value: null as Texture | null },
    farol_fieldEmissions: { value: null as Texture | null },
    farol_fieldCones: { value: null as Texture | null },
    farol_fieldRun: { value: [0, 0, 1, 0] },
    farol_fieldMatrix: { value: new Matrix4() },
    farol_fieldColor: { value: new Vector3() },
    farol_fieldPlanes: { value: Array.from({ length: 6 }, () => new Vector4()) },
    farol_fieldProjection: { value: new Matrix4() },
    farol_fieldDepths: { value: new Vector3() },
  } satisfies Record<string, IUniform>;
  private readonly pass = new FullscreenPass({
    program: 'lights of a field',
    fragment: 'fieldLight',
    uniforms: this.uniforms,
    repeats: true,
  });

  constructor() {
    const cells = this.target.textures[3];
    cells.format = RedFormat;
    cells.type = HalfFloatType;
  }

  get bytes(): number {
    return this.target.width * this.target.height * BYTES;
  }

  /** Begins a frame. @param rows - number of rows of 128 lights in all fields */
  begin(frame: Frame, rows: number, depths: FieldDepths): void {
    const { target, uniforms } = this;
    if (target.height < rows) target.setSize(128, Math.ceil(rows * 1.25));
    const { camera } = frame;
    viewFrustumPlanes(camera.projectionMatrix.elements, planes);
    for (let i = 0; i < 6; i++) uniforms.farol_fieldPlanes.value[i].fromArray(planes, i * 4);
    uniforms.farol_fieldProjection.value.copy(camera.projectionMatrix);
    // four cells in depth, of which the first and last extend to infinity
    uniforms.farol_fieldDepths.value.set(depths.nearest, 4 / depths.extent, depths.isLogarithmic ? 1 : 0);
  }

  /**
   * Draws the lights of a field.
   * @param row - first row of the field in the target
   * @param rows - number of its rows
   */
  draw(
    frame: Frame,
    field: LightField,
    { sphere, emission, cone, width }: FieldSources,
    row: number,
    rows: number,
  ): void {
    const { target, uniforms } = this;
    uniforms.farol_fieldSpheres.value = sphere;
    uniforms.farol_fieldEmissions.value = emission;
    uniforms.farol_fieldCones.value = cone;
    const run = uniforms.farol_fieldRun.value;
    run[0] = fieldCount(field);
    run[1] = row;
    run[2] = width;
    run[3] = cone === null ? 0 : 1;
    uniforms.farol_fieldMatrix.value.multiplyMatrices(frame.camera.matrixWorldInverse, field.matrixWorld);
    const { color, intensity } = field;
    uniforms.farol_fieldColor.value.set(color.r, color.g, color.b).multiplyScalar(intensity);
    target.viewport.set(0, row, 128, rows);
    this.pass.drawTo(frame, target);
  }

  /** Draws for a warm-up, which compiles the program and draws nothing. */
  warmUp(frame: Frame): void {
    this.pass.drawTo(frame, this.target);
  }

  dispose(): void {
    this.target.dispose();
    this.pass.dispose();
  }
}
