import { type Camera, type DirectionalLight, type HemisphereLight, type Light, type PointLight, Vector3 } from 'three';
import { hasCookie, LightFacts, type MaskSettings } from './classifyLight';
import { fetching } from './fetching';
import { fieldCount, type LightFieldData } from './lightData';
import { type PlainPoints, POINT, readPoint } from './plainPoints';
import { boundLight, sphereCoverage, sphereOutsidePlanes, ViewSpace } from './spheres';

const up = new Vector3();

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
  /** Whether lights throw images. */
  hasImages = false;
  /** Whether shadow maps of `light.shadow` are looked up some way off along the normal. */
  hasNormalBias = false;
  /** Number of managed lights in the scene, and of those kept for this frame (ambient and hemisphere ones included). */
  total = 0;
  visible = 0;
  /** Number of managed lights in the scene that are objects of their own, light fields left out. */
  singles = 0;
  /** Sum of the shares of the picture that `boundeds` cover: how many lie over a pixel, whatever its depth. */
  coverage = 0;
  /** Constant and three slopes (x, y, z of the view-space normal) of the ambient irradiance, 4 × RGB. */
  readonly ambient = new Float32Array(12);
  /** Shadows, light layers and area lights of the last frame whose lights were collected. */
  protected settings: MaskSettings | null = null;
  private kept = 0;
  /** Values of plain point lights, read by `collect` when the caller has not read them yet. */
  private ownPoints: PlainPoints = new Float64Array(0);
  private readonly facts = new LightFacts();
  private readonly space = new ViewSpace();

  /**
   * Takes the lights of a frame. World matrices must be up to date.
   * @param lights - managed ones that are visible to the camera's layers
   * @param camera - gives view space and the frustum
   * @param points - what the lights give, read before. Default: read here
   */
  collect(lights: readonly Light[], camera: Camera, settings: MaskSettings, points: PlainPoints | null = null): void {
    const { facts, space } = this;
    space.begin(camera);
    this.settings = settings;
    this.clear(lights);
    // layers are a mask
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
    // the field is counted with its lights, one of which the caller counts
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
    let fetched = 0;
    for (let i = 0; i < lights.length; i++) {
      if (i === fetched) fetched = fetching.reader?.fetchEmissions(lights, i) ?? lights.length;
      if (layers?.separates(lights[i]) === true) ownPoints[i * POINT + 7] = NaN;
      else readPoint(lights[i], ownPoints, i * POINT);
    }
    return ownPoints;
  }

  /**
   * Adds the plain point lights from index `i` on that give light and reach something that is seen.
   * @returns index of the first light that is none
   */
  private addPoints(lights: readonly Light[], from: PlainPoints, i: number): number {
    const { boundeds, cones, emissions, spheres, space, unboundeds } = this;
    const { planes, projection } = space;
    // fields read once: this loop runs for each of thousands of lights
    const { 0: m0, 1: m1, 2: m2, 4: m4, 5: m5, 6: m6, 8: m8, 9: m9, 10: m10 } = space.view.elements;
    const { 12: m12, 13: m13, 14: m14 } = space.view.elements;
    let { kept, visible } = this;
    let { coverage } = space;
    const before = kept;
    for (; i < lights.length; i++) {
      const p = i * POINT;
      const decay = from[p + 7];
      if (Number.isNaN(decay)) break;
      const r = from[p + 4];
      const g = from[p + 5];
      const b = from[p + 6];
      if (r === 0 && g === 0 && b === 0) continue;
      const range = from[p + 3];
      if (range === 0) unboundeds.push(lights[i]);
      else {
        const wx = from[p];
        const wy = from[p + 1];
        const wz = from[p + 2];
        const x = m0 * wx + m4 * wy + m8 * wz + m12;
        const y = m1 * wx + m5 * wy + m9 * wz + m13;
        const z = m2 * wx + m6 * wy + m10 * wz + m14;
        if (sphereOutsidePlanes(planes, x, y, z, range)) continue;
        const at = kept * 4;
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
        coverage += sphereCoverage(-z, range, projection);
        boundeds[kept++] = lights[i];
      }
      visible++;
    }
    this.sphereCount += kept - before;
    this.kept = kept;
    this.visible = visible;
    space.coverage = coverage;
    return i;
  }

  /** Adds a light by its `facts`, unless it reaches nothing that is seen. */
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
