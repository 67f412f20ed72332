import { type Camera, type DirectionalLight, type HemisphereLight, type Light, type PointLight, Vector3 } from 'three';
import { hasCookie, LightFacts, type MaskSettings } from './classifyLight';
import { fieldCount, type LightFieldData } from './lightData';
import { type PlainPoints, POINT, readPoint } from './plainPoints';
import { boundLight, sphereCoverage, sphereOutsidePlanes, ViewSpace } from './spheres';

const up = new Vector3();

/**
 * The lights of a frame by class, in view space: lights with a value that is no finite number, without light, or whose range the
 * camera does not see are left out. Arrays grow as needed and are reused.
 */
export class VisibleLights {
  readonly directionals: DirectionalLight[] = [];
  readonly unboundeds: Light[] = [];
  readonly boundeds: Light[] = [];
  /** Lights of `directionals`, `unboundeds` and `boundeds` that may have a mask. */
  readonly masked: Light[] = [];
  /** Light fields of the frame; the GPU writes the records of their lights. */
  readonly fields: LightFieldData[] = [];
  /** View-space sphere of each of `boundeds`: [x, y, z, r] (m), r its range. */
  spheres = new Float64Array(64);
  /** View-space cone of each of `boundeds`: [axis to the light, cosine of the cutoff]; cosine -1 for a sphere. */
  cones = new Float64Array(64);
  /** Light of each of `boundeds`: colour times intensity, and decay if it is a plain point light, else -1. */
  emissions = new Float64Array(64);
  /** Number of `boundeds` drawn as spheres, and as cones. */
  sphereCount = 0;
  coneCount = 0;
  /** Number of `boundeds` that are area lights. */
  areas = 0;
  /** Whether there are area lights, with a range or without. */
  hasAreas = false;
  /** Whether any light projects an image. */
  hasImages = false;
  /** Whether any `light.shadow` has a normal bias. */
  hasNormalBias = false;
  /** Number of managed lights (by Farol, not three) in the scene; `visible`: in this frame, ambient ones included. */
  total = 0;
  visible = 0;
  /** Number of managed lights in the scene without those of light fields. */
  singles = 0;
  /** Mean number of `boundeds` over a pixel, at any depth: sum of the shares of the picture that they cover. */
  coverage = 0;
  /** Constant and three slopes (x, y, z of the view-space normal) of the ambient irradiance, 4 × RGB. */
  readonly ambient = new Float32Array(12);
  /** Shadows, light layers and area lights passed to the last `collect`. */
  protected settings: MaskSettings | null = null;
  private kept = 0;
  /** Values of plain point lights, read by `collect` when the caller has not read them yet. */
  private ownPoints: PlainPoints = new Float64Array(0);
  private readonly facts = new LightFacts();
  private readonly space = new ViewSpace();

  /**
   * Classifies the lights of a frame. World matrices must be up to date.
   * @param lights - managed lights that the camera's layers see
   * @param camera - camera of the view space and frustum
   * @param points - values of plain point lights, if read already. Default: read here
   */
  collect(lights: readonly Light[], camera: Camera, settings: MaskSettings, points: PlainPoints | null = null): void {
    const { facts, space } = this;
    space.begin(camera);
    this.settings = settings;
    this.clear(lights);
    // with light layers any light may be masked: none is plain
    const read = settings.layers === null ? points : null;
    const from = read ?? this.readPoints(lights, settings);
    for (let i = this.addPoints(lights, from, 0); i < lights.length; i = this.addPoints(lights, from, i + 1))
      if (facts.classify(lights[i], settings)) this.addByClass(lights[i]);
    if (this.boundeds.length > this.kept) this.boundeds.length = this.kept;
    this.coverage = space.coverage;
  }

  private clear(lights: readonly Light[]): void {
    this.directionals.length = this.unboundeds.length = this.masked.length = this.fields.length = 0;
    this.kept = this.sphereCount = this.coneCount = this.areas = this.visible = 0;
    this.hasAreas = this.hasImages = this.hasNormalBias = false;
    this.ambient.fill(0);
    this.total = this.singles = lights.length;
    if (this.spheres.length >= lights.length * 4) return;
    this.spheres = new Float64Array(lights.length * 8);
    this.cones = new Float64Array(lights.length * 8);
    this.emissions = new Float64Array(lights.length * 8);
  }

  private addField(light: LightFieldData): void {
    this.fields.push(light);
    this.singles--;
    // `total` counts a field's lights; the caller has added 1
    const others = fieldCount(light) - 1;
    this.total += others;
    this.visible += others;
  }

  /**
   * Adds the irradiance of an ambient or hemisphere light, a linear function of the view-space normal:
   * mix(ground, sky, 0.5 n·up + 0.5) = 0.5 (sky + ground) + n · 0.5 (sky - ground) up.
   */
  private addAmbient(light: Light): void {
    const { color, intensity } = light;
    const { r, g, b } = (light as HemisphereLight).groundColor ?? color;
    up.setFromMatrixPosition(light.matrixWorld).transformDirection(this.space.view);
    this.addChannel(0, color.r * intensity, r * intensity);
    this.addChannel(1, color.g * intensity, g * intensity);
    this.addChannel(2, color.b * intensity, b * intensity);
  }

  private addChannel(c: number, sky: number, ground: number): void {
    const { ambient } = this;
    const slope = 0.5 * (sky - ground);
    ambient[c] += 0.5 * (sky + ground);
    ambient[3 + c] += slope * up.x;
    ambient[6 + c] += slope * up.y;
    ambient[9 + c] += slope * up.z;
  }

  private readPoints(lights: readonly Light[], { layers }: MaskSettings): PlainPoints {
    if (this.ownPoints.length < lights.length * POINT) this.ownPoints = new Float64Array(lights.length * 2 * POINT);
    const { ownPoints } = this;
    for (let i = 0; i < lights.length; i++) {
      if (layers?.separates(lights[i]) === true) ownPoints[i * POINT + 7] = NaN;
      else readPoint(lights[i], ownPoints, i * POINT);
    }
    return ownPoints;
  }

  /** Adds the visible plain point lights from index `i` on. @returns index of the first light that is not a plain point light */
  private addPoints(lights: readonly Light[], from: PlainPoints, i: number): number {
    const { boundeds, cones, emissions, spheres, space } = this;
    const { elements: m } = space.view;
    for (; i < lights.length; i++) {
      const p = i * POINT;
      const decay = from[p + 7];
      if (Number.isNaN(decay)) break;
      const r = from[p + 4];
      const g = from[p + 5];
      const b = from[p + 6];
      if (r === 0 && g === 0 && b === 0) continue;
      const range = from[p + 3];
      if (range === 0) this.unboundeds.push(lights[i]);
      else {
        const wx = from[p];
        const wy = from[p + 1];
        const wz = from[p + 2];
        const x = m[0] * wx + m[4] * wy + m[8] * wz + m[12];
        const y = m[1] * wx + m[5] * wy + m[9] * wz + m[13];
        const z = m[2] * wx + m[6] * wy + m[10] * wz + m[14];
        if (sphereOutsidePlanes(space.planes, x, y, z, range)) continue;
        const at = this.kept * 4;
        spheres[at] = x;
        spheres[at + 1] = y;
        spheres[at + 2] = z;
        spheres[at + 3] = range;
        cones[at] = cones[at + 1] = 0;
        cones[at + 2] = 1;
        cones[at + 3] = -1;
        emissions[at] = r;
        emissions[at + 1] = g;
        emissions[at + 2] = b;
        emissions[at + 3] = decay >= 0 ? decay : -1;
        space.coverage += sphereCoverage(-z, range, space.projection);
        this.sphereCount++;
        boundeds[this.kept++] = lights[i];
      }
      this.visible++;
    }
    return i;
  }

  /** Adds a light by its `facts`, if its range is visible. */
  private addByClass(light: Light): void {
    const { kind, range, isMasked } = this.facts;
    if (range > 0) {
      const at = this.kept * 4;
      const { cones, emissions, spheres } = this;
      spheres[at + 3] = range;
      if (!boundLight(light, this.space, spheres, cones, at)) return;
      const { color, intensity, decay } = light as PointLight;
      emissions[at] = color.r * intensity;
      emissions[at + 1] = color.g * intensity;
      emissions[at + 2] = color.b * intensity;
      emissions[at + 3] = kind === 'point' && !isMasked && decay >= 0 ? decay : -1;
      if (cones[at + 3] > -1) this.coneCount++;
      else this.sphereCount++;
      if (kind === 'area') this.areas++;
      this.boundeds[this.kept++] = light;
    } else if (kind === 'ambient' || kind === 'hemisphere') this.addAmbient(light);
    else if (kind === 'field') this.addField(light as LightFieldData);
    else (kind === 'directional' ? this.directionals : this.unboundeds).push(light as DirectionalLight);
    if (isMasked) {
      this.masked.push(light);
      this.hasImages ||= hasCookie(light);
      this.hasNormalBias ||= light.castShadow && ((light as PointLight).shadow?.normalBias ?? 0) !== 0;
    }
    if (kind === 'area') this.hasAreas = true;
    this.visible++;
  }
}
