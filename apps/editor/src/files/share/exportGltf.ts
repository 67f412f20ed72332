import type { Scene } from '@farol/engine';
import type { Material, MeshPhysicalMaterial, Object3D, WebGLRenderer } from 'three';
import { breathe } from './gltf/breathe';
import { GltfProfiles, type ProfileWriter } from './gltf/GltfProfiles';
import { GltfScene } from './gltf/GltfScene';

/** A glTF file, and descriptions of what it lacks. */
export interface ExportedGltf {
  readonly blob: Blob;
  /** Descriptions of what the file lacks, one line for each kind of thing. */
  readonly leftOut: readonly string[];
}

/** Parts of GLTFExporter's writer that the export uses. */
interface Writer extends ProfileWriter {
  readonly json: ProfileWriter['json'] & { skins?: { skeleton?: number }[]; buffers?: unknown };
  processNodeAsync(object: Object3D): Promise<number>;
}

/** The part of a material's glTF JSON that the export uses. */
interface MaterialDef {
  readonly extensions?: { readonly KHR_materials_anisotropy?: { readonly anisotropyTexture?: { texCoord?: number } } };
}

/** Sets the UV channel of the anisotropy map, which GLTFExporter omits. */
function nameAnisotropyChannel(material: Material, def: MaterialDef): void {
  const texture = def.extensions?.KHR_materials_anisotropy?.anisotropyTexture;
  if (texture) texture.texCoord = (material as MeshPhysicalMaterial).anisotropyMap!.channel;
}

/**
 * Exports a scene as GLB: objects, meshes, materials, models, clips, cameras and the lights that glTF supports. Yields
 * to the page meanwhile.
 * @param webgl - for reading back textures that no canvas can: compressed ones, floats
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
          // GLTFExporter writes the first joint as `skeleton`: it must be an ancestor of all joints, but may not be;
          // the property is optional
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
