import type { TechniqueName } from '@farol/renderer';
import { FogVolume, VolumetricFog } from '@farol/renderer/volumetric-fog';
import * as THREE from 'three';
import { Bench, type PageImage } from './Bench';
import fogMarch from './fogMarch.glsl?raw';

/** Pixels a froxel along a side, as the default has it at 1280 × 720. */
const PIXELS = 8;
const BOXES: readonly (readonly [number, number, number, number, number, number])[] = [
  [-1.5, 1, -2, 0.5, 2, 0.5],
  [1.5, 0.75, -3, 0.5, 1.5, 0.5],
  [0, 2.5, -6, 3, 0.4, 0.4],
];

/** A yard with a sun, a spot light and lamps in fog, and the same by a march of 512 steps over stock three's picture. */
export class FogScene {
  readonly scene = new THREE.Scene();
  readonly camera: THREE.PerspectiveCamera;
  readonly fog = new VolumetricFog();
  readonly bench: Bench;
  readonly volume = new FogVolume('sphere');
  /** A pane of half opacity across the right half of the picture. */
  readonly pane = new THREE.Mesh(
    new THREE.PlaneGeometry(1.5, 3),
    new THREE.MeshBasicMaterial({ color: 0x4080c0, transparent: true, opacity: 0.5 }),
  );
  private readonly sun = new THREE.DirectionalLight(0xfff0d0, 2);
  private readonly lamps: (THREE.PointLight | THREE.SpotLight)[] = [];
  private readonly boxes = BOXES.map(([x, y, z, a, b, c]) => {
    const mesh = new THREE.Mesh(new THREE.BoxGeometry(2 * a, 2 * b, 2 * c), this.material);
    mesh.position.set(x, y, z);
    return mesh;
  });
  private readonly march: THREE.ShaderMaterial;

  constructor(
    readonly width = 256,
    readonly height = 144,
  ) {
    const { scene, fog, sun, lamps, volume, pane } = this;
    this.bench = new Bench(width, height);
    this.camera = new THREE.PerspectiveCamera(60, width / height, 0.1, 100);
    this.camera.position.set(0.5, 1.5, 4);
    this.camera.lookAt(0, 1.2, -3);
    scene.background = new THREE.Color(0.02, 0.03, 0.05);
    const floor = new THREE.Mesh(new THREE.PlaneGeometry(30, 30), this.material);
    floor.rotation.x = -Math.PI / 2;
    sun.position.set(-6, 8, -6);
    sun.shadow.mapSize.set(1024, 1024);
    Object.assign(sun.shadow.camera, { left: -10, right: 10, top: 10, bottom: -10, far: 40 });
    const spot = new THREE.SpotLight(0x80ffc0, 60, 12, 0.6, 1, 2);
    spot.position.set(3.5, 4, -1);
    spot.target.position.set(0, 0, -3);
    spot.shadow.mapSize.set(512, 512);
    const near = new THREE.PointLight(0xff8040, 6, 8);
    near.position.set(-2.5, 1.6, -3.5);
    near.shadow.mapSize.set(256, 256);
    const far = new THREE.PointLight(0x4060ff, 10, 9);
    far.position.set(2.5, 1.5, -7);
    lamps.push(spot, near, far);
    for (const light of [sun, spot, near]) light.castShadow = true;
    for (const mesh of this.boxes) mesh.castShadow = true;
    for (const mesh of [floor, ...this.boxes]) mesh.receiveShadow = true;
    volume.position.set(2, 0.5, -2);
    volume.scale.set(3, 2, 3);
    pane.position.set(1.4, 1.7, 1);
    scene.add(floor, ...this.boxes, sun, spot, spot.target, near, far, volume, pane);
    scene.add(new THREE.AmbientLight(0x405060, 0.6));
    Object.assign(fog, { density: 0.06, anisotropy: 0.4, height: 1, falloff: 3, distance: 30, time: 0 });
    fog.albedo.setRGB(1, 0.95, 0.9);
    fog.froxels = [width / PIXELS, height / PIXELS, 64];
    this.bench.webgl.shadowMap.enabled = true;
    this.march = new THREE.ShaderMaterial({
      glslVersion: THREE.GLSL3,
      vertexShader: 'void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }',
      fragmentShader: fogMarch,
      defines: { LAMPS: lamps.length, BOXES: BOXES.length },
      uniforms: this.marchUniforms(),
      depthTest: false,
      depthWrite: false,
    });
  }

  private get material(): THREE.MeshStandardMaterial {
    return new THREE.MeshStandardMaterial({ color: 0x909090, roughness: 0.9 });
  }

  /** Farol's picture with fog, after so many frames. @param each - called before each frame */
  byFarol(technique: TechniqueName, frames: number, each: (frame: number) => void = () => undefined): PageImage {
    const { bench, scene, camera, fog } = this;
    bench.farol.effects = [fog];
    fog.reset();
    let image!: PageImage;
    for (let i = 0; i < frames; i++) {
      each(i);
      image = bench.byTechnique(technique, scene, camera);
    }
    return image;
  }

  /** The picture by stock three and the march, of opaque things and then the pane over them. */
  byMarch(): PageImage {
    const { pane, volume, scene } = this;
    const wasThere = pane.visible;
    pane.visible = volume.visible = false;
    const image = this.marched(scene);
    volume.visible = true;
    if (wasThere) {
      pane.visible = true;
      const alone = new THREE.Scene();
      alone.add(pane);
      const { material } = pane;
      Object.assign(material, { transparent: false, opacity: 1 });
      alone.background = new THREE.Color(-1, -1, -1);
      const mask = this.bench.stock(alone, this.camera);
      const layer = this.marched(alone);
      scene.add(pane);
      Object.assign(material, { transparent: true, opacity: 0.5 });
      for (let i = 0; i < image.data.length; i += 4) {
        if (mask.data[i] < 0) continue;
        for (let k = i; k < i + 3; k++) image.data[k] = (image.data[k] + layer.data[k]) / 2;
      }
    }
    pane.visible = wasThere;
    return image;
  }

  private marched(scene: THREE.Scene): PageImage {
    const { bench, camera, march, width, height } = this;
    const { webgl } = bench;
    const target = new THREE.WebGLRenderTarget(width, height, {
      type: THREE.FloatType,
      minFilter: THREE.NearestFilter,
      magFilter: THREE.NearestFilter,
      depthTexture: new THREE.DepthTexture(width, height, THREE.FloatType),
    });
    webgl.setRenderTarget(target);
    webgl.render(scene, camera);
    Object.entries(this.marchUniforms()).forEach(([name, { value }]) => (march.uniforms[name].value = value));
    march.uniforms.picture.value = target.texture;
    march.uniforms.depths.value = target.depthTexture;
    const all = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), march);
    all.frustumCulled = false;
    const image = bench.draw(() => webgl.render(all, camera));
    target.depthTexture!.dispose();
    target.dispose();
    return image;
  }

  private marchUniforms() {
    const { camera, fog, sun, lamps, volume } = this;
    camera.updateMatrixWorld();
    this.scene.updateMatrixWorld();
    const ambient = new THREE.Color(0x405060).multiplyScalar(0.6);
    const values = {
      picture: null as THREE.Texture | null,
      depths: null as THREE.Texture | null,
      clipToView: camera.projectionMatrixInverse,
      viewToWorld: camera.matrixWorld,
      fog: new THREE.Vector4(fog.density, fog.anisotropy, fog.height, fog.falloff),
      albedo: fog.albedo,
      farthest: fog.distance,
      ambient,
      sunDirection: sun.position.clone().normalize(),
      sunColor: sun.color.clone().multiplyScalar(sun.intensity),
      lampPosition: lamps.map(({ position }) => position),
      lampColor: lamps.map(({ color, intensity }) => color.clone().multiplyScalar(intensity)),
      lampRange: lamps.map(({ distance }) => distance),
      lampCone: lamps.map((lamp) => {
        if (!(lamp instanceof THREE.SpotLight)) return new THREE.Vector4(0, 0, 0, -1);
        const { x, y, z } = lamp.target.position.clone().sub(lamp.position).normalize();
        return new THREE.Vector4(x, y, z, Math.cos(lamp.angle));
      }),
      lampShadow: lamps.map(({ castShadow }) => (castShadow ? 1 : 0)),
      boxLow: BOXES.map(([x, y, z, a, b, c]) => new THREE.Vector3(x - a, y - b, z - c)),
      boxHigh: BOXES.map(([x, y, z, a, b, c]) => new THREE.Vector3(x + a, y + b, z + c)),
      volumeInverse: volume.matrixWorld.clone().invert(),
      volume: new THREE.Vector4(volume.density, volume.softness, 1, 0),
    };
    return Object.fromEntries(Object.entries(values).map(([name, value]) => [name, { value: value as unknown }]));
  }
}
