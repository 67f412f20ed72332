/**
 * Service worker of a built app: answers its files from a store of this version, so that it works without a network. `FILES`
 * is written by `offlineApp`: `kept` are fetched at once, `all` when first used, or when the app was installed.
 */
/* global FILES */
const { app, version, kept, all } = FILES;
const store = `${app}-${version}`;

const keep = async (names) => {
  const cache = await caches.open(store);
  await cache.addAll(names.map((name) => new Request(name, { cache: 'no-cache' })));
};

/** Name of the app's file that a request asks for; null for anything else. */
function nameOf({ method, url, mode }) {
  const { scope } = self.registration;
  if (method !== 'GET' || !url.startsWith(scope)) return null;
  const [name] = url.slice(scope.length).split(/[?#]/);
  if (mode === 'navigate' && name === '') return 'index.html';
  return all.includes(name) ? name : null;
}

async function answer(request, name) {
  const cache = await caches.open(store);
  const found = await cache.match(name);
  if (found) return found;
  const fetched = await fetch(request);
  if (fetched.ok) await cache.put(name, fetched.clone());
  return fetched;
}

self.addEventListener('install', (event) => event.waitUntil(keep(kept)));

self.addEventListener('activate', (event) => {
  const clean = async () => {
    const names = await caches.keys();
    await Promise.all(
      names.filter((name) => name.startsWith(`${app}-`) && name !== store).map((name) => caches.delete(name)),
    );
    await self.clients.claim();
  };
  event.waitUntil(clean());
});

self.addEventListener('fetch', (event) => {
  const name = nameOf(event.request);
  if (name) event.respondWith(answer(event.request, name));
});

self.addEventListener('message', (event) => {
  if (event.data === 'begin') void self.skipWaiting();
  else if (event.data === 'all') event.waitUntil(keep(all));
});
