import { AssetLibrary, type AssetLibraryOptions } from '@farol/engine';

/** An asset library that loads only from this host and from hosts that the user allowed. */
export function makeLibrary(options: AssetLibraryOptions = {}): AssetLibrary {
  const library = new AssetLibrary(options);
  library.allowedOrigins = new Set();
  // meshes of the samples are offered in every scene; files that use them load them by themselves
  void import('./sampleMeshes').then(({ registerSceneAssets }) => registerSceneAssets(library));
  return library;
}
