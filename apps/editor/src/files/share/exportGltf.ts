import type { Scene } from '@farol/engine';
import type { Material, MeshPhysicalMaterial, Object3D, WebGLRenderer } from 'three';
import { breathe } from './gltf/breathe';
import { GltfProfiles, type ProfileWriter } from './gltf/GltfProfiles';
import { GltfScene } from './gltf/GltfScene';

/** A glTF, and what it could not take along. */
export interface ExportedGltf {
  readonly blob: Blob;
  /** A line for each kind of thing. */
  readonly leftOut: readonly string[];
}

/** The part of GLTFExporter's writer that is used here. */
interface Writer extends ProfileWriter {
  readonly json: ProfileWriter['json'] & { skins?: { skeleton?: number }[]; buffers?: unknown };
  processNodeAsync(object: Object3D): Promise<number>;
}

/** A material in a glTF, as far as it is read here. */
interface MaterialDef {
  readonly extensions?: { readonly KHR_materials_anisotropy?: { readonly anisotropyTexture?: { texCoord?: number } } };
}

/** Names the texture coordinates of the anisotropy map, which the exporter leaves out. */
function nameAnisotropyChannel(material: Material, def: MaterialDef): void {
  const texture = def.extensions?.KHR_materials_anisotropy?.anisotropyTexture;
  if (texture) texture.texCoord = (material as MeshPhysicalMaterial).anisotropyMap!.channel;
}

/**
 * The scene as a GLB: tree, meshes, materials, models, clips, cameras and the lights that glTF knows. The page answers meanwhile.
 * @param webgl - reads textures that no canvas can: compressed ones, floats
 * @throws Error (as a rejection) naming the object and its texture when one cannot be read
 * @see glTF 2.0, KHR_lights_punctual, EXT_lights_ies
 */
export async function exportGltf(scene: Scene, webgl: WebGLRenderer): Promise<ExportedGltf> {
  const { GLTFExporter } = await import('three/addons/exporters/GLTFExporter.js');
  const source = await GltfScene.make(scene, webgl);
  try {
    const exporter = new GLTFExporter();
    exporter.register((given) => {
      const writer = given as unknown as Writer;
      const profiles = new GltfProfiles(writer, source.profiles);
      const processNode = writer.processNodeAsync.bind(writer);
      writer.processNodeAsync = async (object) => {
        await breathe();
        await profiles.prepare(object);
        return processNode(object);
      };
      return {
        writeMaterialAsync: async (material: Material, def: object) => nameAnisotropyChannel(material, def),
        writeNode: (object, nodeDef) => profiles.writeNode(object, nodeDef),
        afterParse: () => {
          // the exporter names the first joint, which need not be above all others; the property may be left out
          writer.json.skins?.forEach((skin) => Reflect.deleteProperty(skin, 'skeleton'));
          profiles.finish();
        },
      };
    });
    const animations = [...source.animations];
    const options = { binary: true, onlyVisible: false, trs: true, animations };
    const glb = (await exporter.parseAsync(source.three, options)) as ArrayBuffer;
    return { blob: new Blob([glb], { type: 'model/gltf-binary' }), leftOut: source.leftOut.lines };
  } finally {
    source.dispose();
  }
}
