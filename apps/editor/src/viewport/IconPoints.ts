import {
  AudioSource,
  Camera,
  type Component,
  type ComponentClass,
  Decal,
  FogVolume,
  type GameObject,
  Light,
  ParticleEmitter,
  type Scene,
} from '@farol/engine';
import {
  BufferAttribute,
  BufferGeometry,
  type Camera as ThreeCamera,
  DynamicDrawUsage,
  OrthographicCamera,
  Points,
  ShaderMaterial,
  type Vector2,
  Vector3,
} from 'three';
import { iconKinds, makeIconAtlas } from './iconAtlas';
import fragmentShader from './icons.frag.glsl?raw';
import vertexShader from './icons.vert.glsl?raw';
import type { EditorDocument } from '../model/EditorDocument';
import type { PickHit } from './pick';
import type { SceneStamps } from './SceneStamps';

/** Size of an icon (CSS pixels) when there are few. */
const SIZE = 20;
/** Number of icons from which they become smaller, so that the scene stays visible between them. */
const MANY = 60;
/** Smallest size of an icon (CSS pixels). */
const LEAST = 8;

const kindOf: Readonly<Record<string, number>> = Object.fromEntries(iconKinds.map((kind, i) => [kind, i]));
const types: readonly ComponentClass[] = [Light, Camera, Decal, FogVolume, AudioSource, ParticleEmitter];
/** Icons by component type; lights have icons of their own. */
const kinds: Readonly<Record<string, string>> = {
  Camera: 'camera',
  Decal: 'decal',
  FogVolume: 'fog',
  AudioSource: 'sound',
  ParticleEmitter: 'particles',
};
const place = new Vector3();

/** Clickable icons for lights, cameras and other objects that draw nothing themselves; one draw call. */
export class IconPoints extends Points<BufferGeometry, ShaderMaterial> {
  private readonly shown: GameObject[] = [];
  /** Current size of an icon (CSS pixels). */
  private size = SIZE;
  /** State for which the icons were last updated. */
  private readonly drawn = {
    scene: null as Scene | null,
    without: null as Camera | null,
    ...{ places: -1, icons: -1, selection: -1, pixelRatio: 0 },
  };

  constructor() {
    super(
      new BufferGeometry(),
      new ShaderMaterial({
        name: 'Editor icons',
        vertexShader,
        fragmentShader,
        uniforms: { atlas: { value: makeIconAtlas() }, size: { value: SIZE }, count: { value: iconKinds.length } },
        transparent: true,
        depthWrite: false,
        toneMapped: false,
      }),
    );
    this.frustumCulled = false;
    this.grow(64);
  }

  /**
   * Updates positions and colours when something has changed since the last call.
   * @param without - the camera whose view is shown, which gets no icon
   */
  follow(
    { scene, selection }: EditorDocument,
    { places, icons }: SceneStamps,
    pixelRatio: number,
    without: Camera | null,
  ): void {
    const { drawn } = this;
    const { revision } = selection.changed;
    const isSame =
      drawn.scene === scene && drawn.places === places && drawn.icons === icons && drawn.without === without;
    if (isSame && drawn.selection === revision && drawn.pixelRatio === pixelRatio) return;
    if (!isSame) this.collect(scene, without);
    this.select(selection.ids);
    this.material.uniforms.size.value = this.size * pixelRatio;
    Object.assign(drawn, { scene, places, icons, without, selection: revision, pixelRatio });
  }

  /**
   * The icon closest to a point of the viewport.
   * @param point - normalised device coordinates
   * @param width - viewport width (CSS pixels)
   * @param height - viewport height (CSS pixels)
   */
  pick(camera: ThreeCamera, point: Vector2, width: number, height: number): PickHit | null {
    let nearest: PickHit | null = null;
    let leastDistance = Math.max(this.size, SIZE / 2) / 2 + 1;
    for (const object of this.shown) {
      if (object.lockedInHierarchy) continue;
      place.setFromMatrixPosition(object.object3D.matrixWorld);
      let distance = place.distanceTo(cameraPlace.setFromMatrixPosition(camera.matrixWorld));
      if (camera instanceof OrthographicCamera) distance = -place.applyMatrix4(camera.matrixWorldInverse).z;
      else place.applyMatrix4(camera.matrixWorldInverse);
      place.applyMatrix4(camera.projectionMatrix);
      if (place.z < -1 || place.z > 1) continue;
      const away = Math.hypot(((place.x - point.x) * width) / 2, ((place.y - point.y) * height) / 2);
      if (away >= leastDistance) continue;
      leastDistance = away;
      nearest = { object, distance };
    }
    return nearest;
  }

  override dispose(): void {
    this.geometry.dispose();
    this.material.uniforms.atlas.value.dispose();
    this.material.dispose();
  }

  private collect(scene: Scene, without: Camera | null): void {
    this.shown.length = 0;
    let count = 0;
    for (const type of types) count += scene.componentsOf(type).length;
    this.size = Math.max(LEAST, SIZE * Math.min(1, Math.sqrt(MANY / Math.max(count, 1))));
    this.grow(count);
    for (const type of types) {
      for (const each of scene.componentsOf(type)) if (each.isActive && each !== without) this.addIcon(each);
    }
    this.geometry.setDrawRange(0, this.shown.length);
    for (const name in this.geometry.attributes) this.geometry.attributes[name].needsUpdate = true;
  }

  private select(ids: readonly string[]): void {
    const selected = new Set(ids);
    const attribute = this.geometry.attributes.selected as BufferAttribute;
    for (let i = 0; i < this.shown.length; i++) attribute.array[i] = selected.has(this.shown[i].id) ? 1 : 0;
    attribute.needsUpdate = true;
  }

  private addIcon(component: Component): void {
    const { geometry } = this;
    const { gameObject } = component;
    const i = this.shown.length;
    this.shown.push(gameObject);
    const { elements } = gameObject.object3D.matrixWorld;
    geometry.attributes.position.setXYZ(i, elements[12], elements[13], elements[14]);
    const isDecal = component instanceof Decal;
    geometry.attributes.kind.setX(i, kindOf[component instanceof Light ? component.type : kinds[component.typeName]]);
    if (component instanceof Light || isDecal) {
      const [r, g, b] = component.colour;
      const largest = Math.max(r, g, b, 1e-6);
      geometry.attributes.tint.setXYZ(
        i,
        0.25 + (0.75 * r) / largest,
        0.25 + (0.75 * g) / largest,
        0.25 + (0.75 * b) / largest,
      );
    } else geometry.attributes.tint.setXYZ(i, 0.6, 0.75, 0.9);
  }

  private grow(count: number): void {
    const { geometry } = this;
    if (geometry.attributes.position && geometry.attributes.position.count >= count) return;
    const room = 2 ** Math.ceil(Math.log2(Math.max(count, 64)));
    geometry.dispose();
    for (const [name, size] of [
      ['position', 3],
      ['tint', 3],
      ['kind', 1],
      ['selected', 1],
    ] as const) {
      geometry.setAttribute(name, new BufferAttribute(new Float32Array(room * size), size).setUsage(DynamicDrawUsage));
    }
  }
}

const cameraPlace = new Vector3();
