#!/usr/bin/env node
import {run} from './run.js';

// a reader that closes the pipe early, such as `| head -1`, is no error
process.stdout.on('error', () => process.exit());

await run(process.argv.slice(2));
