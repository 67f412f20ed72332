import { Scene as EngineScene } from '@farol/engine';
import { instantiatePrefab, type Prefab } from '@farol/engine/prefabs';
import { readPixels } from '@farol/renderer/read-pixels';
import {
  Box3,
  DataUtils,
  DirectionalLight,
  HalfFloatType,
  HemisphereLight,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  type Object3D,
  OrthographicCamera,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  Sphere,
  SphereGeometry,
  Vector3,
  WebGLRenderTarget,
} from 'three';
import { clone } from 'three/addons/utils/SkeletonUtils.js';
import { drawsFloats } from '../viewport/drawsFloats';
import { renderSmall } from '../viewport/renderSmall';
import type { Viewport } from '../viewport/Viewport';
import { whenLost } from '../viewport/whenLost';
import { whenRestored } from '../viewport/whenRestored';
import type { AssetEntry } from './assetKinds';
import { profilePicture } from './profilePicture';
import { soundPicture } from './soundPicture';

/** Side of a thumbnail (pixels). */
const SIZE = 96;

/** Tone-maps linear light to an sRGB byte. @see Reinhard 2002, equation 4, white at 4 */
function encode(linear: number): number {
  const light = Math.max(0, linear);
  const toned = light <= 0.8 ? light : 0.8 + 0.2 * (1 - 1 / (1 + (light - 0.8) * 2));
  return 255 * (toned <= 0.0031308 ? toned * 12.92 : 1.055 * toned ** (1 / 2.4) - 0.055);
}

/** Renders thumbnails of assets with the viewport's renderer, one at a time while the page is idle. */
export class ThumbnailMaker {
  private readonly target = new WebGLRenderTarget(SIZE, SIZE, { type: HalfFloatType, samples: 4 });
  private readonly pixels = new Uint16Array(SIZE * SIZE * 4);
  private readonly pictures = new WeakMap<object, Map<string, Promise<string | null>>>();
  /** Pending thumbnails; the one requested last is rendered first. */
  private readonly waiting: (() => Promise<void>)[] = [];
  private isDrawing = false;

  constructor(private readonly viewport: Viewport) {
    whenLost(viewport.webgl, () => this.target.dispose());
  }

  /** URL of an asset's thumbnail; null when none can be rendered now. Cached until the asset changes. */
  pictureOf(entry: AssetEntry): Promise<string | null> {
    const { scene, assets } = this.viewport.document;
    if (entry.kind === 'script' || entry.kind === 'clip' || entry.kind === 'surface') return Promise.resolve(null);
    const prefab = entry.kind === 'prefab' ? scene.prefabs.get(entry.name) : null;
    const material = entry.kind === 'material' ? assets.materialAsset(entry.name) : null;
    const owner: object = prefab ?? material ?? assets;
    let known = this.pictures.get(owner);
    if (!known) this.pictures.set(owner, (known = new Map()));
    const revision = material ? this.viewport.document.ownerSignal(material).revision : 0;
    const key = material ? String(revision) : `${entry.kind}/${entry.name}`;
    // drops thumbnails of earlier states of the material
    if (material && !known.has(key)) this.forget(known);
    let picture = known.get(key);
    if (!picture) {
      picture = new Promise((resolve) => {
        this.waiting.push(async () => resolve(await this.draw(entry, prefab)));
      });
      void this.drawWaiting();
      known.set(key, picture);
      // a missing thumbnail is not cached, so that an asset that was not loaded yet is tried again
      void picture.then((address) => address ?? known.delete(key));
    }
    return picture;
  }

  private async drawWaiting(): Promise<void> {
    if (this.isDrawing) return;
    this.isDrawing = true;
    while (this.waiting.length > 0) {
      await idle();
      await this.waiting.pop()!();
    }
    this.isDrawing = false;
  }

  /** Revokes URLs, after a delay so that images that show them can be replaced. */
  private forget(pictures: Map<string, Promise<string | null>>): void {
    for (const picture of pictures.values()) {
      void picture.then((address) => address && setTimeout(() => URL.revokeObjectURL(address), 10_000));
    }
    pictures.clear();
  }

  /** Renders an asset, retrying once after a lost context. */
  private async draw(entry: AssetEntry, prefab: Prefab | null): Promise<string | null> {
    let picture: string | null | undefined;
    do {
      await whenRestored(this.viewport.webgl);
      picture = await this.drawOnce(entry, prefab);
    } while (picture === undefined);
    return picture;
  }

  /** @returns undefined when the context was lost meanwhile */
  private async drawOnce(entry: AssetEntry, prefab: Prefab | null): Promise<string | null | undefined> {
    let release = (): void => {};
    try {
      const { assets } = this.viewport.document;
      if (prefab) {
        const stage = new EngineScene({ assets, registry: this.viewport.document.scene.registry });
        release = () => stage.dispose();
        stage.add(instantiatePrefab(prefab, stage.registry));
        return await this.render(stage.three);
      }
      if (entry.kind === 'prefab' || !assets.isReady(entry.kind, entry.name)) return null;
      if (entry.kind === 'sound') return await soundPicture(assets.sound(entry.name));
      if (entry.kind === 'profile') return await profilePicture(assets.profile(entry.name));
      if (entry.kind === 'mesh') await assets.prepareMesh(entry.name);
      const { subject, dispose } = this.subjectOf(entry);
      release = dispose;
      const stage = new Scene();
      stage.add(subject);
      return await this.render(stage, entry.kind === 'texture');
    } catch {
      // the asset cannot be rendered: its card shows an icon
      return null;
    } finally {
      release();
    }
  }

  private subjectOf({ kind, name }: AssetEntry): { subject: Object3D; dispose(): void } {
    const { assets } = this.viewport.document;
    if (kind === 'model') return { subject: clone(assets.model(name).scene), dispose: () => {} };
    if (kind === 'mesh') {
      const material = new MeshStandardMaterial({ color: 0xb8bcc4, roughness: 0.7 });
      return { subject: new Mesh(assets.mesh(name), material), dispose: () => material.dispose() };
    }
    if (kind === 'texture') {
      const geometry = new PlaneGeometry(2, 2);
      const material = new MeshBasicMaterial({ map: assets.texture(name), toneMapped: false });
      return {
        subject: new Mesh(geometry, material),
        dispose: () => {
          geometry.dispose();
          material.dispose();
        },
      };
    }
    const geometry = new SphereGeometry(1, 32, 16);
    const material = kind === 'shader' ? assets.shader(name) : assets.material(name);
    return { subject: new Mesh(geometry, material), dispose: () => geometry.dispose() };
  }

  /** @returns undefined when the context was lost meanwhile */
  private async render(stage: Scene, isFlat = false): Promise<string | null | undefined> {
    const { webgl } = this.viewport;
    const lights = [new HemisphereLight(0xdfe8ff, 0x55504a, 1.6), new DirectionalLight(0xffffff, 2.4)];
    lights[1].position.set(2, 3, 2.5);
    stage.add(...lights);
    const camera = isFlat ? flatCamera() : cameraFor(stage);
    // the result is read back as half floats
    if (!camera || !drawsFloats(webgl)) return null;
    const previousState = { target: webgl.getRenderTarget(), alpha: webgl.getClearAlpha(), autoClear: webgl.autoClear };
    webgl.setRenderTarget(this.target);
    webgl.setClearAlpha(0);
    webgl.autoClear = true;
    try {
      renderSmall(webgl, stage, camera);
    } finally {
      webgl.setRenderTarget(previousState.target);
      webgl.setClearAlpha(previousState.alpha);
      webgl.autoClear = previousState.autoClear;
      stage.remove(...lights);
    }
    if (!(await readPixels(webgl, this.target, 0, 0, SIZE, SIZE, this.pixels))) return undefined;
    return this.toAddress();
  }

  private toAddress(): Promise<string | null> {
    const canvas = document.createElement('canvas');
    canvas.width = canvas.height = SIZE;
    const context = canvas.getContext('2d')!;
    const image = context.createImageData(SIZE, SIZE);
    for (let y = 0; y < SIZE; y++) {
      for (let x = 0; x < SIZE; x++) {
        const from = (y * SIZE + x) * 4;
        const to = ((SIZE - 1 - y) * SIZE + x) * 4;
        const alpha = DataUtils.fromHalfFloat(this.pixels[from + 3]);
        for (let i = 0; i < 3; i++) {
          const light = DataUtils.fromHalfFloat(this.pixels[from + i]) / Math.max(alpha, 1e-3);
          image.data[to + i] = encode(light);
        }
        image.data[to + 3] = alpha * 255;
      }
    }
    context.putImageData(image, 0, 0);
    return new Promise((resolve) => {
      canvas.toBlob((blob) => resolve(blob && URL.createObjectURL(blob)));
    });
  }
}

const idle = (): Promise<void> =>
  new Promise((resolve) => {
    if ('requestIdleCallback' in window) requestIdleCallback(() => resolve(), { timeout: 500 });
    else setTimeout(resolve, 20);
  });

function flatCamera(): OrthographicCamera {
  const camera = new OrthographicCamera(-1, 1, 1, -1, 0, 2);
  camera.position.z = 1;
  return camera;
}

/** A camera that frames everything from the front, right and above; null when there is nothing to see. */
function cameraFor(stage: Scene): PerspectiveCamera | null {
  stage.updateMatrixWorld(true);
  const box = new Box3().setFromObject(stage);
  if (box.isEmpty()) return null;
  const { center, radius } = box.getBoundingSphere(new Sphere());
  const size = Math.max(radius, 1e-4);
  const camera = new PerspectiveCamera(30, 1, size * 0.05, size * 20);
  camera.position.copy(center).addScaledVector(new Vector3(0.62, 0.48, 1).normalize(), size / Math.sin(Math.PI / 12));
  camera.lookAt(center);
  return camera;
}
