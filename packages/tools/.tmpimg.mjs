import { chromium } from 'playwright-core';
import { ensureBrowser } from './ensureBrowser.mjs';
import { readFileSync } from 'node:fs';
const b = await chromium.launch({ executablePath: ensureBrowser() });
const p = await b.newPage({ viewport: { width: 660, height: 380 } });
await p.setContent(process.argv.slice(3).map((f) => `<img src="data:image/webp;base64,${readFileSync(f).toString('base64')}">`).join(''));
await p.screenshot({ path: process.argv[2] });
await b.close();
