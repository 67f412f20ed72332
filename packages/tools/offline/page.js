/** Keeps the app for times without a network, and says when another version of it is there. */
const texts = {
  en: ['A new version is there.', 'Reload'],
  es: ['Hay una versión nueva.', 'Recargar'],
};

/** Shows that a version waits, above all else; it begins once the user says so. */
function offer(waiting) {
  const [text, action] = texts[document.documentElement.lang] ?? texts.en;
  const line = Object.assign(document.createElement('p'), { role: 'status', textContent: `${text} ` });
  line.style.cssText =
    'position:fixed;z-index:99;bottom:0;right:0;margin:0;padding:8px 12px;background:#222b;color:#fff;font:14px sans-serif';
  const button = Object.assign(document.createElement('button'), { type: 'button', textContent: action });
  button.addEventListener('click', () => {
    navigator.serviceWorker.addEventListener('controllerchange', () => location.reload());
    waiting.postMessage('begin', []);
  });
  line.append(button);
  document.body.append(line);
}

async function begin() {
  const registration = await navigator.serviceWorker.register('./sw.js');
  const look = () => registration.waiting && navigator.serviceWorker.controller && offer(registration.waiting);
  look();
  registration.addEventListener('updatefound', () =>
    registration.installing?.addEventListener('statechange', ({ target }) => target.state === 'installed' && look()),
  );
  const keepAll = () => navigator.serviceWorker.ready.then(({ active }) => active?.postMessage('all', []));
  if (matchMedia('(display-mode: standalone)').matches) await keepAll();
  addEventListener('appinstalled', () => void keepAll());
}

// without a service worker, as in some private windows, the app needs a network
if ('serviceWorker' in navigator) addEventListener('load', () => void begin().catch(() => {}));
