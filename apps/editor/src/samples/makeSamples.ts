import { containerContent, writeContainer } from '@farol/engine/files';
import { animation } from './animation';
import { fire } from './fire';
import { bakedRoom } from './bakedRoom';
import { microshaders } from './microshaders';
import { nightInTheTemple } from './nightInTheTemple';
import { physics } from './physics';
import { prefabs } from './prefabs';
import { scripts } from './scripts';
import { shading } from './shading';
import { surfaces } from './surfaces';
import type { ReadPublic, SampleScene } from './SampleScene';

/** Function that builds each sample, by file name in `public/scenes`. */
export const sampleMakers: Readonly<Record<string, (readPublic: ReadPublic) => Promise<SampleScene>>> = {
  'night-in-the-temple.farol': nightInTheTemple,
  'fire.json': fire,
  'baked-room.farol': bakedRoom,
  'animation.json': animation,
  'physics.json': physics,
  'scripts.json': scripts,
  'prefabs.json': prefabs,
  'microshaders.json': microshaders,
  'shading.json': shading,
  'surfaces.json': surfaces,
};

/**
 * The bytes of a sample's file, reproducible: a container for '.farol', else JSON.
 * @param readPublic - reads a file below `public`
 * @throws FileError (as a rejection) naming the faults
 */
export async function makeSample(file: string, readPublic: ReadPublic): Promise<Uint8Array> {
  const scene = await (await sampleMakers[file](readPublic)).build();
  const content = containerContent(scene);
  scene.dispose();
  if (file.endsWith('.farol')) return writeContainer(content);
  return new TextEncoder().encode(`${JSON.stringify(content.file, null, 1)}\n`);
}
