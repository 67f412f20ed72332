import type { Scene } from '@farol/engine';
import type { WebGLRenderer } from 'three';
import { breathe } from './gltf/breathe';
import { GltfScene } from './gltf/GltfScene';

/** A glTF, and what it could not take along. */
export interface ExportedGltf {
  readonly blob: Blob;
  /** A line for each kind of thing. */
  readonly leftOut: readonly string[];
}

/** The part of GLTFExporter's writer that is used here. */
interface Writer {
  readonly json: { skins?: { skeleton?: number }[]; buffers?: unknown };
  processNodeAsync(object: unknown): Promise<number>;
}

/**
 * The scene as a GLB: tree, meshes, materials, models, clips, cameras and the lights that glTF knows. The page answers meanwhile.
 * @param webgl - reads textures that no canvas can: compressed ones, floats
 * @throws Error (as a rejection) naming the object and its texture when one cannot be read
 * @see glTF 2.0, KHR_lights_punctual
 */
export async function exportGltf(scene: Scene, webgl: WebGLRenderer): Promise<ExportedGltf> {
  const { GLTFExporter } = await import('three/addons/exporters/GLTFExporter.js');
  const source = await GltfScene.make(scene, webgl);
  try {
    const exporter = new GLTFExporter();
    exporter.register((given) => {
      const writer = given as unknown as Writer;
      const processNode = writer.processNodeAsync.bind(writer);
      writer.processNodeAsync = async (object) => {
        await breathe();
        return processNode(object);
      };
      return {
        // the exporter names the first joint, which need not be above all others; the property may be left out
        afterParse: () => writer.json.skins?.forEach((skin) => Reflect.deleteProperty(skin, 'skeleton')),
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
