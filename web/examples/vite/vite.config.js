import {defineConfig} from 'vite';

const headers = {
  'Content-Security-Policy': [
    "default-src 'none'",
    "script-src 'self' 'wasm-unsafe-eval'",
    "worker-src 'self'",
    "style-src 'self'",
    "img-src 'self'",
    "connect-src 'self'",
  ].join('; '),
};

export default defineConfig({server: {headers}, preview: {headers}});
