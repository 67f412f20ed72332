import {
  type Camera,
  Color,
  DoubleSide,
  type Material,
  Matrix3,
  type Mesh,
  type MeshStandardMaterial,
  type Object3D,
  type Scene,
  ShaderMaterial,
  type Texture,
  type WebGLRenderer,
} from 'three';
import fragmentShader from './unlit.frag.glsl?raw';
import vertexShader from './unlit.vert.glsl?raw';

const unmoved = new Matrix3();

/** Override material that shows the colour and the map of each object's own material. */
export class UnlitMaterial extends ShaderMaterial {
  constructor() {
    super({
      name: 'Editor unlit',
      vertexShader,
      fragmentShader,
      uniforms: {
        colour: { value: new Color() },
        emitted: { value: new Color() },
        opacity: { value: 1 },
        alphaTest: { value: 0 },
        hasMap: { value: false },
        map: { value: null },
        mapTransform: { value: new Matrix3() },
      },
      side: DoubleSide,
      toneMapped: false,
    });
  }

  /** three calls this before it draws an object */
  override onBeforeRender(
    _webgl: WebGLRenderer,
    _scene: Scene,
    _camera: Camera,
    _geometry: unknown,
    object: Object3D,
    group: unknown,
  ): void {
    const material = (object as Mesh).material;
    const index = (group as { materialIndex?: number } | null)?.materialIndex ?? 0;
    this.copyFrom((Array.isArray(material) ? material[index] : material) as Material | undefined);
  }

  private copyFrom(material: Material | undefined): void {
    const { colour, emitted, opacity, alphaTest, hasMap, map, mapTransform } = this.uniforms;
    const source = material as Partial<MeshStandardMaterial> | undefined;
    const texture: Texture | null = source?.map ?? null;
    if (source?.color) colour.value.copy(source.color);
    else colour.value.setScalar(0.5);
    if (source?.emissive) emitted.value.copy(source.emissive).multiplyScalar(source.emissiveIntensity ?? 1);
    else emitted.value.setScalar(0);
    opacity.value = source?.transparent ? (source.opacity ?? 1) : 1;
    alphaTest.value = source?.alphaTest ?? 0;
    hasMap.value = texture !== null;
    map.value = texture;
    if (texture?.matrixAutoUpdate) texture.updateMatrix();
    mapTransform.value.copy(texture?.matrix ?? unmoved);
    this.uniformsNeedUpdate = true;
  }
}
