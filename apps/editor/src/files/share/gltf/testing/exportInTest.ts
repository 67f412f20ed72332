import type { Scene } from '@farol/engine';
import type { WebGLRenderer } from 'three';
import { exportGltf } from '../../exportGltf';

/** Replaces `FileReader`, which Node lacks, for GLTFExporter. */
export class PageFileReader {
  result: ArrayBuffer | null = null;
  onloadend: (() => void) | null = null;
  readAsArrayBuffer(blob: Blob): void {
    void blob.arrayBuffer().then((bytes) => {
      this.result = bytes;
      this.onloadend?.();
    });
  }
}

/** Exports a scene without textures, for which no renderer is needed. */
export async function exportInTest(scene: Scene): ReturnType<typeof exportGltf> {
  return exportGltf(scene, null as unknown as WebGLRenderer);
}

/** The parts of a GLB. @see glTF 2.0, 4.4 */
export interface GlbParts<Json> {
  readonly json: Json;
  readonly bytes: ArrayBuffer;
  /** Offset of the binary chunk's data (bytes). */
  readonly start: number;
}

export async function partsOfGlb<Json>(blob: Blob): Promise<GlbParts<Json>> {
  const bytes = await blob.arrayBuffer();
  const length = new DataView(bytes).getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 20, length))) as Json;
  return { json, bytes, start: 20 + length + 8 };
}
