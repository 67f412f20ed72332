import { createHash } from 'node:crypto';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { parseSync, Visitor } from 'vite';
import { policyElement } from '../contentSecurityPolicy.mjs';

/** Base that VitePress builds with; {@link makeRelative} takes it out again. */
export const placeholderBase = '/FAROL_SITE_BASE/';

/** Script that says where the site begins, and gives links their whole path before Vue takes them over. @param {string} up */
const findBase = (up) =>
  `<script>FAROL_SITE_BASE=new URL("${up}",location).pathname;for(const a of document.querySelectorAll("a[href]"))if(!/^(#|[a-z]+:)/.test(a.getAttribute("href")))a.setAttribute("href",a.pathname+a.hash)</script>`;

/** Script of a host's page for addresses that are not there, of any depth: looks for the site in the folders above. */
const findBaseAbove = `<script>(async()=>{let at=new URL(".",location);while(at.pathname!=="/"&&!(await fetch(new URL("hashmap.json",at),{method:"HEAD"})).ok)at=new URL("..",at);FAROL_SITE_BASE=at.pathname;const parts=document.querySelector("template").content;for(const part of parts.children)for(const name of["href","src"])if(part.hasAttribute(name))part.setAttribute(name,part.getAttribute(name).replace("${placeholderBase}",FAROL_SITE_BASE));document.head.append(document.importNode(parts,true))})()</script>`;

/** The page for addresses that are not there: its scripts and styles are fetched once the site is found. @param {string} html */
function withBaseAbove(html) {
  /** @type {string[]} */
  const parts = [];
  const rest = html.replace(/<(?:link|script)\b[^>]*"\/FAROL_SITE_BASE\/[^>]*>(?:<\/script>)?/g, (part) => {
    parts.push(part);
    return '';
  });
  return rest.replace('</body>', () => `<template>${parts.join('')}</template>${findBaseAbove}</body>`);
}

/**
 * Makes a built site work from any folder of any host, where VitePress knows fixed bases alone; and gives its pages a
 * content security policy. The icons' small style sheet, for which a page would wait, goes into the pages.
 *
 * @param {string} dist - folder that VitePress built with {@link placeholderBase}
 */
export function makeRelative(dist) {
  const icons = readFileSync(join(dist, 'vp-icons.css'), 'utf8');
  for (const name of readdirSync(dist, { recursive: true, encoding: 'utf8' })) {
    const path = join(dist, name);
    const up = '../'.repeat(name.split(/[\\/]/).length - 1) || './';
    const change = (/** @type {(text: string) => string} */ of) => writeFileSync(path, of(readFileSync(path, 'utf8')));
    if (name.endsWith('.css')) change((text) => text.replaceAll(placeholderBase, up));
    if (name.endsWith('.js')) change((text) => scriptWithBase(name, text));
    if (name === '404.html') change((text) => withPolicy(withBaseAbove(text)));
    else if (name.endsWith('.html'))
      change((text) =>
        withPolicy(
          text
            .replace(/<link [^>]*vp-icons\.css"[^>]*>/, icons && `<style>${icons}</style>`)
            .replaceAll(placeholderBase, up)
            .replace('</body>', () => `${findBase(up)}</body>`),
        ),
      );
  }
}

/**
 * A page that fetches from its own host alone, and runs no other scripts than its own.
 *
 * @param {string} html
 */
function withPolicy(html) {
  const hashes = [...html.matchAll(/<script(?![^>]*\ssrc=)[^>]*>(.*?)<\/script>/gs)].map(
    ([, script]) => `'sha256-${createHash('sha256').update(script).digest('base64')}'`,
  );
  const policy = [
    "default-src 'self'",
    `script-src 'self' ${hashes.join(' ')}`,
    "style-src 'self' 'unsafe-inline'",
    "img-src 'self' data:",
    "base-uri 'none'",
    "form-action 'none'",
  ].join('; ');
  return html.replace('<meta charset="utf-8">', (meta) => `${meta}\n    ${policyElement(policy)}`);
}

/**
 * A script whose strings take the base from the page.
 *
 * @param {string} name
 * @param {string} text
 * @returns {string}
 */
export function scriptWithBase(name, text) {
  if (!text.includes(placeholderBase)) return text;
  /** @type {{ start: number, end: number }[]} */
  const places = [];
  const note = (/** @type {{ start: number, end: number }} */ { start, end }) => {
    if (text.slice(start, end).includes(placeholderBase)) places.push({ start, end });
  };
  new Visitor({ Literal: note, TemplateLiteral: note }).visit(parseSync(name, text).program);
  let result = text;
  for (const { start, end } of places.toSorted((a, b) => b.start - a.start))
    result = `${result.slice(0, start)}(${result.slice(start, end)}).replaceAll(${JSON.stringify(placeholderBase)},globalThis.FAROL_SITE_BASE)${result.slice(end)}`;
  return result;
}
