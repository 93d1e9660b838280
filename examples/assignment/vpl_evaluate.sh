#!/usr/bin/env bash
# vpl_evaluate.sh of Moodle's Virtual Programming Lab. The server has Steradian installed; the grade is up to 100.
printf '#!/usr/bin/env bash\nsteradian assignment check . --assignment a3 --vpl 100\n' >vpl_execution
chmod +x vpl_execution
