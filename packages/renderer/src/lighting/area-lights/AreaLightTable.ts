import type { IUniform, Matrix4, RectAreaLight, Texture, WebGLRenderer } from 'three';
import { Vector3 } from 'three';
import type { DataTable } from '../../gpu/DataTable';
import type { AreaRadii, FarolLightData } from '../../lights/lightData';
import type { MicroShaderRegistry } from '../../microshaders';
import { needArea } from './areaFeatures';
import { AREA, areaShapes } from './areaRecord';
import { makeTransforms } from './makeTransforms';

/** Finite value for an infinite range of an area light (m). */
const ENDLESS = 1e30;
const NO_DATA: FarolLightData = {};
const axis = new Vector3();

/** Measures area lights and writes their extension records. */
export class AreaLightTable implements AreaRadii {
  /** Irradiance below which an area light without `userData.farol.range` is cut off; 0: never cut off. */
  threshold = 0;
  private readonly transforms;

  /**
   * @param uniform - uniform for the table of linearly transformed cosines
   * @param microshaders - registry to which code for the kinds of area lights is added
   */
  constructor(
    webgl: WebGLRenderer,
    private readonly uniform: IUniform<Texture | null>,
    private readonly microshaders: MicroShaderRegistry,
  ) {
    this.transforms = makeTransforms(webgl);
    uniform.value = this.transforms;
  }

  radiusOf(light: RectAreaLight): number {
    const { width, height } = light;
    if (!(width > 0 && height > 0)) return NaN;
    const reach = this.reachOf(light);
    needArea(this.microshaders, shapeOf(light), reach !== 0);
    return reach === 0 ? 0 : reach + 0.5 * Math.hypot(width, height);
  }

  /** Writes the extension record of a light. @param at - offset of the record in the table (floats) */
  write(table: DataTable, at: number, light: RectAreaLight, view: Matrix4): void {
    const shape = shapeOf(light);
    const world = light.matrixWorld;
    axis
      .setFromMatrixColumn(world, 0)
      .normalize()
      .transformDirection(view)
      .multiplyScalar(0.5 * light.width);
    table.set4(at + AREA.across, axis.x, axis.y, axis.z, shape);
    axis
      .setFromMatrixColumn(world, 1)
      .normalize()
      .transformDirection(view)
      .multiplyScalar(0.5 * light.height);
    table.set4(at + AREA.up, axis.x, axis.y, axis.z, this.reachOf(light) || ENDLESS);
  }

  /** Bytes of the tables of linearly transformed cosines. */
  get bytes(): number {
    return (this.transforms.image.data as Uint16Array).byteLength;
  }

  dispose(): void {
    this.transforms.dispose();
    this.uniform.value = null;
  }

  /** Distance from the light's surface beyond which it gives nothing (m); 0 for no end. */
  private reachOf(light: RectAreaLight): number {
    const { range, shape } = dataOf(light);
    if (range !== undefined && range >= 0) return range;
    if (!(this.threshold > 0)) return 0;
    // far from the light, irradiance is radiance × area / distance²; near the light it is less
    const { r, g, b } = light.color;
    const area = light.width * light.height * (shape === 'disc' ? Math.PI / 4 : 1);
    return Math.sqrt((Math.max(r, g, b) * Math.abs(light.intensity) * area) / this.threshold) || NaN;
  }
}

function shapeOf(light: RectAreaLight): number {
  return areaShapes[dataOf(light).shape ?? 'rectangle'] ?? areaShapes.rectangle;
}

function dataOf(light: RectAreaLight): FarolLightData {
  return (light.userData.farol as FarolLightData | undefined) ?? NO_DATA;
}
