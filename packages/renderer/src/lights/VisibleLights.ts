import type {
  Camera,
  DirectionalLight,
  HemisphereLight,
  Light,
  Matrix4,
  PointLight,
  RectAreaLight,
  SpotLight,
} from 'three';
import { Vector3 } from 'three';
import { AmbientSum } from './AmbientSum';
import { classifyLight, mayBeMasked, type LightClass, type MaskSettings } from './classifyLight';
import { coneBoundingSphere } from './coneBoundingSphere';
import { FiniteLights } from './FiniteLights';
import { fieldCount, type LightFieldData } from './LightFieldData';
import { isBlackLight } from './isBlackLight';
import { lightAxis } from './lightAxis';
import { lightRange } from './lightRange';
import { sphereCoverage } from './sphereCoverage';
import { sphereOutsidePlanes } from './sphereOutsidePlanes';
import { viewFrustumPlanes } from './viewFrustumPlanes';

/** Cones wider than this are drawn and culled as spheres (rad). */
const WIDEST_CONE = 1.05;

const axis = new Vector3();
const planes = new Float64Array(24);
const coneSphere = new Float64Array(4);

/**
 * The lights of a frame by class, in view space: those that have a value which is no number, give no light, or reach
 * nothing that the camera sees are left out. Arrays grow to what is needed and are kept.
 */
export class VisibleLights {
  readonly directionals: DirectionalLight[] = [];
  readonly unboundeds: Light[] = [];
  readonly boundeds: Light[] = [];
  /** Lights of `directionals`, `unboundeds` and `boundeds` that may have a mask. */
  readonly masked: Light[] = [];
  /** Light fields, whose records the GPU writes. */
  readonly fields: LightFieldData[] = [];
  /** View-space sphere of each of `boundeds`: [x, y, z, r] (m), r its range. */
  bounds = new Float64Array(64);
  /** View-space cone of each of `boundeds`: [axis to the light, cosine of the cutoff]; cosine -1 for a sphere. */
  axes = new Float64Array(64);
  /** Light of each of `boundeds`: colour times intensity, and decay if it is a plain point light, else -1. */
  plain = new Float64Array(64);
  /** Number of `boundeds` drawn as spheres, and as cones. */
  spheres = 0;
  cones = 0;
  /** Number of `boundeds` that are area lights. */
  areas = 0;
  /** Whether there are area lights, with a range or without. */
  hasAreas = false;
  /**
   * Number of managed lights in the scene, and of those kept for this frame (ambient and hemisphere lights included).
   */
  total = 0;
  visible = 0;
  /** Sum of the shares of the picture that `boundeds` cover: how many lie over a pixel, whatever its depth. */
  coverage = 0;
  /** Constant and three slopes (x, y, z of the view-space normal) of the ambient irradiance, 4 × RGB. */
  readonly ambient: Float32Array;
  /** Mask settings of the last frame collected. */
  protected settings: MaskSettings | null = null;
  private kept = 0;
  private readonly finite = new FiniteLights();
  private readonly ambientSum = new AmbientSum();

  constructor() {
    this.ambient = this.ambientSum.values;
  }

  /**
   * Takes the lights of a frame. World matrices must be up to date.
   * @param lights - managed ones that are visible to the camera's layers
   * @param camera - gives view space and the frustum
   */
  collect(lights: readonly Light[], camera: Camera, masks: MaskSettings): void {
    const view = camera.matrixWorldInverse;
    const projection = camera.projectionMatrix.elements;
    viewFrustumPlanes(projection, planes);
    this.settings = masks;
    this.clear(lights.length);
    for (const light of lights) {
      if (!this.finite.check(light)) continue;
      const kind = classifyLight(light);
      if (kind === 'hemisphere') this.ambientSum.addHemisphere(light as HemisphereLight, view);
      else if (kind === 'ambient') this.ambientSum.addAmbient(light);
      else if (kind === 'field') this.addField(light as LightFieldData);
      else if (isBlackLight(light)) continue;
      else if (kind === 'directional') this.addEndless(light, this.directionals, masks);
      else if (kind === 'unbounded') this.addEndless(light, this.unboundeds, masks);
      else {
        const range = kind === 'area' ? masks.areas!.radiusOf(light as RectAreaLight) : lightRange(light as PointLight);
        if (range === 0) this.addEndless(light, this.unboundeds, masks);
        else if (!this.addBounded(light, kind, range, view, projection, masks)) continue;
        if (kind === 'area') this.hasAreas = true;
      }
      this.visible++;
    }
    if (this.boundeds.length > this.kept) this.boundeds.length = this.kept;
  }

  private clear(count: number): void {
    this.directionals.length = this.unboundeds.length = this.masked.length = this.fields.length = 0;
    this.kept = this.spheres = this.cones = this.areas = this.visible = this.coverage = 0;
    this.hasAreas = false;
    this.ambientSum.clear();
    this.total = count;
    if (this.bounds.length >= count * 4) return;
    this.bounds = new Float64Array(count * 8);
    this.axes = new Float64Array(count * 8);
    this.plain = new Float64Array(count * 8);
  }

  private addField(field: LightFieldData): void {
    this.fields.push(field);
    // the field is counted with its lights, one of which the caller counts
    const others = fieldCount(field) - 1;
    this.total += others;
    this.visible += others;
  }

  private addEndless(light: Light, to: Light[], masks: MaskSettings): void {
    to.push(light);
    if (mayBeMasked(light, masks)) this.masked.push(light);
  }

  /** @returns false for a light that reaches nothing that is seen */
  private addBounded(
    light: Light,
    kind: LightClass,
    range: number,
    view: Matrix4,
    projection: ArrayLike<number>,
    masks: MaskSettings,
  ): boolean {
    const v = view.elements;
    const m = light.matrixWorld.elements;
    const wx = m[12];
    const wy = m[13];
    const wz = m[14];
    const x = v[0] * wx + v[4] * wy + v[8] * wz + v[12];
    const y = v[1] * wx + v[5] * wy + v[9] * wz + v[13];
    const z = v[2] * wx + v[6] * wy + v[10] * wz + v[14];
    if (!(range > 0) || sphereOutsidePlanes(planes, x, y, z, range)) return false;
    const { bounds, axes, plain } = this;
    const at = this.kept * 4;
    const spot = light as SpotLight;
    if (kind === 'spot' && spot.angle < WIDEST_CONE) {
      lightAxis(spot, view, axis);
      coneBoundingSphere(x, y, z, -axis.x, -axis.y, -axis.z, range, spot.angle, coneSphere);
      if (sphereOutsidePlanes(planes, coneSphere[0], coneSphere[1], coneSphere[2], coneSphere[3])) return false;
      axes[at] = axis.x;
      axes[at + 1] = axis.y;
      axes[at + 2] = axis.z;
      axes[at + 3] = Math.cos(spot.angle);
      this.cones++;
    } else {
      axes[at] = axes[at + 1] = 0;
      axes[at + 2] = 1;
      axes[at + 3] = -1;
      this.spheres++;
    }
    if (kind === 'area') this.areas++;
    bounds[at] = x;
    bounds[at + 1] = y;
    bounds[at + 2] = z;
    bounds[at + 3] = range;
    const isMasked = mayBeMasked(light, masks);
    if (isMasked) this.masked.push(light);
    const isPlain = kind === 'point' && !isMasked && (light as PointLight).decay >= 0;
    if (isPlain) {
      const { color, intensity } = light;
      plain[at] = color.r * intensity;
      plain[at + 1] = color.g * intensity;
      plain[at + 2] = color.b * intensity;
    }
    plain[at + 3] = isPlain ? (light as PointLight).decay : -1;
    this.boundeds[this.kept++] = light;
    this.coverage += sphereCoverage(-z, range, projection);
    return true;
  }
}
