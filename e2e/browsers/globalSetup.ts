import { serveApps } from '@farol/tools/serveApps';
import { problemScript } from './problems';

/** As support/globalSetup.ts, from source, with a script in each page that keeps what goes wrong there. */
export default async function globalSetup(): Promise<() => Promise<void>> {
  const { urls, close } = await serveApps({
    ports: { editor: 0, viewer: 0, lab: 0, pages: 0 },
    watch: false,
    plugins: [
      {
        name: 'farol-keep-problems',
        transformIndexHtml: () => [{ tag: 'script', children: problemScript, injectTo: 'head-prepend' }],
      },
    ],
  });
  for (const [name, url] of Object.entries(urls)) process.env[`FAROL_${name.toUpperCase()}_URL`] = url;
  return close;
}
