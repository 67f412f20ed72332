/**
 * Content security policy of Farol's pages. Scripts are its own files alone; WebAssembly decodes models; workers are its own or made of
 * its own text; pictures come as bytes. Libraries of controls write style elements.
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
    // the Lab measures in frames of its own
    "frame-src 'self'",
    "style-src 'self' 'unsafe-inline'",
    "img-src 'self' data: blob:",
    "font-src 'self' data:",
    // any host that the user was asked about
    `connect-src 'self' data: blob: https: http:${isServed ? ' ws: wss:' : ''}`,
    "manifest-src 'self'",
    "base-uri 'none'",
    "form-action 'none'",
  ].join('; ');
}

/** A policy as an element for the head of a page. @param {string} policy */
export const policyElement = (policy) => `<meta http-equiv="Content-Security-Policy" content="${policy}" />`;

/**
 * Headers of an answer, by its path: pages are shown in frames of their own host alone, so that nobody leads clicks into
 * them; the player's are made to be embedded.
 *
 * @param {string} path
 * @returns {Record<string, string>}
 */
export const frameHeaders = (path) =>
  /^\/player(-scripts)?\.html(\?|$)/.test(path) ? {} : { 'content-security-policy': "frame-ancestors 'self'" };

/**
 * Vite plugin: puts the policy into each page, the strict one into what is built.
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
      // before anything that it is about
      handler: (html) =>
        html.replace('<head>', `<head>\n    ${policyElement(contentSecurityPolicy({ isServed, runsScripts }))}`),
    },
  };
}
