/**
 * Content security policy of Farol's pages. Scripts come from the page's own host alone; WebAssembly is allowed
 * since it decodes models, blobs since workers and pictures are made of bytes, style elements since controls add them.
 *
 * @param {object} [options]
 * @param {boolean} [options.isServed] - the development server puts scripts into pages and pushes changes; default false
 * @param {boolean} [options.runsScripts] - the page compiles scripts of scenes and runs them; default false
 * @see Content Security Policy Level 3
 */
export function contentSecurityPolicy({ isServed = false, runsScripts = false } = {}) {
  return [
    "default-src 'none'",
    `script-src 'self' 'wasm-unsafe-eval'${runsScripts ? ' blob:' : ''}${isServed ? " 'unsafe-inline'" : ''}`,
    "worker-src 'self' blob:",
    // iframes of the Lab's own page, in which it measures
    "frame-src 'self'",
    "style-src 'self' 'unsafe-inline'",
    "img-src 'self' data: blob:",
    "font-src 'self' data:",
    // any host, since users may open files from anywhere; the page asks them first
    `connect-src 'self' data: blob: https: http:${isServed ? ' ws: wss:' : ''}`,
    "manifest-src 'self'",
    "base-uri 'none'",
    "form-action 'none'",
  ].join('; ');
}

/** A policy as an element for the head of a page. @param {string} policy */
export const policyElement = (policy) => `<meta http-equiv="Content-Security-Policy" content="${policy}" />`;

/**
 * Headers of a response, by path: against clickjacking, only its own host may frame a page; any host the player's.
 *
 * @param {string} path
 * @returns {Record<string, string>}
 */
export const frameHeaders = (path) =>
  /^\/player(-scripts)?\.html(\?|$)/.test(path) ? {} : { 'content-security-policy': "frame-ancestors 'self'" };

/**
 * Vite plugin: puts the policy into each page; only that of built pages forbids inline scripts.
 *
 * @param {object} [options]
 * @param {boolean} [options.runsScripts] - see `contentSecurityPolicy`
 * @returns {import('vite').Plugin}
 */
export function securePages({ runsScripts = false } = {}) {
  let isServed = false;
  return {
    name: 'farol-content-security-policy',
    configResolved(config) {
      isServed = config.command === 'serve';
    },
    configureServer({ middlewares }) {
      middlewares.use((request, response, next) => {
        for (const [name, value] of Object.entries(frameHeaders(request.url ?? ''))) response.setHeader(name, value);
        next();
      });
    },
    transformIndexHtml: {
      order: 'post',
      // first in the head: the policy rules only what follows it
      handler: (html) =>
        html.replace('<head>', `<head>\n    ${policyElement(contentSecurityPolicy({ isServed, runsScripts }))}`),
    },
  };
}
