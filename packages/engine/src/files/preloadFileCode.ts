/** Fetches what is otherwise fetched with the first file: what reads assets, and what packs and unpacks containers. */
export async function preloadFileCode(): Promise<void> {
  await Promise.all([
    import('three/addons/libs/fflate.module.js'),
    import('../assets/readAsset'),
    import('./obj/objToGlb'),
  ]);
}
