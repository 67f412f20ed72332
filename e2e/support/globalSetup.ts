import { serveApps } from '@farol/tools/serveApps';

/**
 * Serves the apps and the tests' own pages on free ports for the whole run, and leaves their URLs in the environment:
 * FAROL_EDITOR_URL, FAROL_VIEWER_URL, FAROL_LAB_URL, FAROL_LIVE_URL, FAROL_PAGES_URL. Edits made while the tests run are not followed.
 */
export default async function globalSetup(): Promise<() => Promise<void>> {
  const { urls, close } = await serveApps({
    ports: { editor: 0, viewer: 0, lab: 0, live: 0, pages: 0 },
    built: process.env.FAROL_E2E === 'built',
    watch: false,
  });
  process.env.FAROL_EDITOR_URL = urls.editor;
  process.env.FAROL_VIEWER_URL = urls.viewer;
  process.env.FAROL_LAB_URL = urls.lab;
  process.env.FAROL_LIVE_URL = urls.live;
  process.env.FAROL_PAGES_URL = urls.pages;
  return close;
}
