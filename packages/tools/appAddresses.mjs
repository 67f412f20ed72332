/** Name of the file beside each app that says where the others are. */
export const addressFile = 'apps.json';

/**
 * Addresses of the apps, as each of them reads them from `apps.json` beside it, relative to that file. Built apps are meant to
 * lie in folders of these names beside one another.
 */
export const besideOneAnother = { editor: '../editor/', viewer: '../viewer/', lab: '../lab/', gallery: '../gallery/' };

/**
 * Vite plugin: writes `apps.json` into what is built. In development and in tests `serveApps` answers it, since each app has
 * a port of its own.
 *
 * @returns {import('vite').Plugin}
 */
export function appAddresses() {
  return {
    name: 'farol-app-addresses',
    apply: 'build',
    generateBundle() {
      this.emitFile({ type: 'asset', fileName: addressFile, source: `${JSON.stringify(besideOneAnother)}\n` });
    },
  };
}
