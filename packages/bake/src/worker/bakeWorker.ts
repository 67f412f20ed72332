import createXAtlas from 'xatlas-wasm';
import { type StitchRequest, stitchLightmap } from '../seams/stitchLightmap';
import { type Charts, cutCharts } from '../unwrap/cutCharts';
import { packMeshes } from '../unwrap/packMeshes';
import type { PackOptions, SurfaceToUnwrap, Unwrapped } from '../unwrap/UnwrapRequest';

export type BakeQuestion =
  | { readonly kind: 'cut'; readonly surface: SurfaceToUnwrap }
  | {
      readonly kind: 'pack';
      readonly surfaces: readonly Charts[];
      readonly meshes: readonly number[];
      readonly options: PackOptions;
    }
  | { readonly kind: 'stitch'; readonly request: StitchRequest };

/** Result of a request, by its kind. */
export interface BakeResults {
  readonly cut: Charts;
  readonly pack: Unwrapped;
  readonly stitch: Float32Array;
}

export type BakeAnswer =
  | { readonly kind: 'progress'; readonly share: number }
  | { readonly kind: 'failed'; readonly message: string }
  | { readonly kind: 'done'; readonly result: BakeResults[keyof BakeResults] };

const tell = (answer: BakeAnswer, transferred: Transferable[] = []): void =>
  postMessage(answer, { transfer: transferred });
const onProgress = (share: number): void => tell({ kind: 'progress', share });
let xatlas: ReturnType<typeof createXAtlas> | null = null;

addEventListener('message', async ({ data }: MessageEvent<BakeQuestion>) => {
  try {
    if (data.kind === 'cut') {
      tell({ kind: 'done', result: cutCharts(await (xatlas ??= createXAtlas()), data.surface) });
    } else if (data.kind === 'pack') {
      const surfaces = data.meshes.map((surface) => data.surfaces[surface]);
      tell({ kind: 'done', result: packMeshes(surfaces, data.options, onProgress) });
    } else {
      const result = stitchLightmap(data.request);
      tell({ kind: 'done', result }, [result.buffer]);
    }
  } catch (error) {
    tell({ kind: 'failed', message: error instanceof Error ? error.message : String(error) });
  }
});
