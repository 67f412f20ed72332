/** Fetches the late code of files in advance: readers of assets, and packing of containers. */
export async function preloadFileCode(): Promise<void> {
  await Promise.all([
    import('three/addons/libs/fflate.module.js'),
    import('../assets/readAsset'),
    import('./obj/objToGlb'),
  ]);
}
