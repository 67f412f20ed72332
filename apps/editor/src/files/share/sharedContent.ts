import type { Scene } from '@farol/engine';
import { containerContent, type ContainerContent } from '@farol/engine/files';

export interface ShareOptions {
  /** Whether the scene's scripts are included; default true. Without them their components are kept as data. */
  readonly withScripts?: boolean;
}

export function sharedContent(scene: Scene, { withScripts = true }: ShareOptions = {}): ContainerContent {
  const { file, files } = containerContent(scene);
  const assets = file.assets.filter(({ type }) => withScripts || type !== 'script');
  return { file: { ...file, assets }, files };
}
