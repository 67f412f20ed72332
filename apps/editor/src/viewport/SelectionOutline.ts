import type { GameObject } from '@farol/engine';
import {
  type Camera,
  Color,
  DoubleSide,
  LinearFilter,
  type Material,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  OrthographicCamera,
  PlaneGeometry,
  RedFormat,
  Scene,
  ShaderMaterial,
  SkinnedMesh,
  Vector2,
  Vector4,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { drawnMeshes } from './drawnMeshes';
import fragmentShader from './outline.frag.glsl?raw';
import vertexShader from './outline.vert.glsl?raw';

/** Maximum number of outlined meshes; more would make the mask as expensive as the frame. */
const MOST_MESHES = 2000;

/** Line width (CSS pixels). */
const WIDTH = 2;

const size = new Vector2();
const viewport = new Vector4();

/** Stand-in drawn into the mask for a mesh of the scene. */
interface Stand {
  readonly mesh: Mesh;
  readonly world: Matrix4;
  /** The scene's mesh; null when this is a copy of one instance among many. */
  readonly source: Mesh | null;
}

/**
 * Outline of the selection, visible through other objects. Copies of the selected meshes, which share their geometry
 * and bones, are drawn into a mask, whose edge is drawn over the frame. The scene is not touched.
 */
export class SelectionOutline {
  private readonly masked = new Scene();
  private readonly flat = new MeshBasicMaterial({ color: 0xffffff, side: DoubleSide, toneMapped: false, fog: false });
  private readonly target = new WebGLRenderTarget(1, 1, {
    format: RedFormat,
    minFilter: LinearFilter,
    magFilter: LinearFilter,
    samples: 4,
  });
  private readonly over = new Scene();
  private readonly overCamera = new OrthographicCamera();
  private readonly edge: ShaderMaterial;
  private readonly clear = new Color();
  private stands: Stand[] = [];
  private standsOf = '';
  private readonly cutouts = new Map<Material, MeshBasicMaterial>();

  /** @param colour - CSS colour */
  constructor(colour: string) {
    this.masked.matrixWorldAutoUpdate = false;
    this.edge = new ShaderMaterial({
      name: 'Editor outline',
      vertexShader,
      fragmentShader,
      uniforms: {
        mask: { value: this.target.texture },
        texel: { value: new Vector2() },
        radius: { value: WIDTH },
        // the colour is not converted to linear, since the frame is already sRGB-encoded
        colour: { value: new Color().setStyle(colour, '') },
      },
      transparent: true,
      depthTest: false,
      depthWrite: false,
      toneMapped: false,
    });
    const triangle = new Mesh(new PlaneGeometry(2, 2), this.edge);
    triangle.frustumCulled = false;
    this.over.add(triangle);
  }

  /**
   * Draws outlines over the frame just rendered with the same camera.
   * @param objects - outlined with their descendants
   * @param key - changes whenever their set of meshes may change
   */
  render(webgl: WebGLRenderer, camera: Camera, objects: readonly GameObject[], key: string): void {
    if (key !== this.standsOf) this.collect(objects, key);
    if (this.stands.length === 0) return;
    for (const { mesh, world, source } of this.stands) {
      mesh.matrixWorld.copy(world);
      if (mesh instanceof SkinnedMesh && source instanceof SkinnedMesh) {
        mesh.bindMatrixInverse.copy(source.bindMatrixInverse);
      }
    }
    webgl.getDrawingBufferSize(size);
    this.target.setSize(size.x, size.y);
    // the outline is drawn over the GL viewport, which may be a part of the canvas
    webgl.getCurrentViewport(viewport);
    this.edge.uniforms.texel.value.set(1 / viewport.z, 1 / viewport.w);
    this.edge.uniforms.radius.value = WIDTH * webgl.getPixelRatio();
    const previousTarget = webgl.getRenderTarget();
    const alpha = webgl.getClearAlpha();
    webgl.getClearColor(this.clear);
    webgl.setRenderTarget(this.target);
    webgl.setClearColor(0x000000, 0);
    webgl.clear();
    webgl.render(this.masked, camera);
    webgl.setRenderTarget(previousTarget);
    webgl.setClearColor(this.clear, alpha);
    webgl.render(this.over, this.overCamera);
  }

  dispose(): void {
    this.forget();
    this.target.dispose();
    this.flat.dispose();
    this.edge.dispose();
    (this.over.children[0] as Mesh).geometry.dispose();
  }

  private forget(): void {
    this.masked.clear();
    this.stands = [];
    for (const material of this.cutouts.values()) material.dispose();
    this.cutouts.clear();
  }

  private collect(objects: readonly GameObject[], key: string): void {
    this.standsOf = key;
    this.forget();
    const seen = new Set<GameObject>();
    const visit = (object: GameObject): void => {
      if (!object.activeInHierarchy || seen.has(object) || this.stands.length >= MOST_MESHES) return;
      seen.add(object);
      drawnMeshes(object, (mesh, geometry, world) => {
        if (mesh && !mesh.visible) return;
        const stand = this.standFor(mesh, geometry);
        this.masked.add(stand);
        this.stands.push({ mesh: stand, world, source: mesh });
      });
      object.children.forEach(visit);
    };
    objects.forEach(visit);
  }

  private standFor(mesh: Mesh | null, geometry: Mesh['geometry']): Mesh {
    const material = mesh && !Array.isArray(mesh.material) ? this.flatFor(mesh.material) : this.flat;
    let stand: Mesh;
    if (mesh instanceof SkinnedMesh) {
      const skinned = new SkinnedMesh(geometry, material);
      skinned.bind(mesh.skeleton, mesh.bindMatrix);
      stand = skinned;
    } else stand = new Mesh(geometry, material);
    if (mesh?.morphTargetInfluences) {
      stand.morphTargetInfluences = mesh.morphTargetInfluences;
      stand.morphTargetDictionary = mesh.morphTargetDictionary;
    }
    stand.matrixAutoUpdate = false;
    stand.matrixWorldAutoUpdate = false;
    stand.frustumCulled = false;
    return stand;
  }

  /** Mask material that discards the same pixels as the mesh's own material. */
  private flatFor(material: Material): MeshBasicMaterial {
    if (material.alphaTest === 0) return this.flat;
    let flat = this.cutouts.get(material);
    if (!flat) {
      const { map = null, alphaMap = null } = material as MeshBasicMaterial;
      flat = this.flat.clone();
      flat.setValues({ alphaTest: material.alphaTest, map: map ?? alphaMap, alphaMap });
      this.cutouts.set(material, flat);
    }
    return flat;
  }
}
